#include "gui/panels/kept/kept_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "base/check.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/overlay.h"
#include "gui/widgets/shorten.h"
#include "gui/widgets/text_field.h"
#include "gui/widgets/widgets.h"
#include "options/option.h"

namespace ps::gui {
namespace {

void heading(const char* text) {
  const FontScope bold(Face::bold);
  ImGui::TextUnformatted(text);
}

/// An entry's name, in the room that its buttons leave.
void entry_name(const KeptEntry& entry, float buttons) {
  ImGui::AlignTextToFramePadding();
  const float room = ImGui::GetContentRegionAvail().x - buttons;
  ImGui::TextUnformatted(whole_words(entry.name, room).c_str());
  tooltip(entry.name);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - buttons);
}

/// The last button of a row. Answers whether the entry shall go.
bool delete_button(std::string_view name, const KeptEntry& entry) {
  ImGui::SameLine(0, px(4));
  return button(fmt::format("{}/delete", name), "Delete", Emphasis::quiet,
                {.tooltip = fmt::format("Deletes \"{}\".", entry.name)});
}

void presets(Session& session, KeptState& state) {
  heading("Presets: all options of a picture");
  std::optional<std::size_t> gone;
  const float buttons = button_width("Into A") + button_width("Into B") + button_width("Delete") + px(8) +
                        ImGui::GetStyle().ItemSpacing.x;
  for (std::size_t i = 0; i < state.presets.size(); ++i) {
    const KeptEntry& entry = state.presets[i];
    const std::string name = fmt::format("preset/{}", i);
    entry_name(entry, buttons);
    for (const Side side : both_sides) {
      if (side == Side::b) ImGui::SameLine(0, px(4));
      if (button(fmt::format("{}/{}", name, side == Side::a ? "a" : "b"), fmt::format("Into {}", letter_of(side)),
                 Emphasis::plain, {.tooltip = entry.text.empty() ? "All options at their defaults." : entry.text}))
        apply_preset(session, side, entry);
    }
    if (delete_button(name, entry)) gone = i;
  }
  const float fields = button_width("Keep A's") + button_width("Keep B's") + px(8);
  text_field("preset-name", state.preset_name, "Name of a preset",
             {.width = ImGui::GetContentRegionAvail().x - fields - px(4)});
  const std::string_view nameless = state.preset_name.empty() ? "It needs a name." : "";
  for (const Side side : both_sides) {
    ImGui::SameLine(0, px(4));
    if (button(side == Side::a ? "keep-a" : "keep-b", fmt::format("Keep {}'s", letter_of(side)), Emphasis::plain,
               {.tooltip = "Keeps all options of this picture under the name.", .disabled = nameless}))
      keep_preset(session, state, side, state.preset_name);
  }
  if (!gone) return;
  state.presets.erase(state.presets.begin() + static_cast<std::ptrdiff_t>(*gone));
  state.remember(presets_key, kept_lines(state.presets));
}

void bookmarks(Session& session, KeptState& state) {
  heading("Bookmarks: the whole screen");
  std::optional<std::size_t> gone;
  const float buttons = button_width("Open") + button_width("Delete") + px(4) + ImGui::GetStyle().ItemSpacing.x;
  for (std::size_t i = 0; i < state.bookmarks.size(); ++i) {
    const KeptEntry& entry = state.bookmarks[i];
    const std::string name = fmt::format("bookmark/{}", i);
    entry_name(entry, buttons);
    if (button(name + "/open", "Open", Emphasis::plain, {.tooltip = "Shows the screen as it was then."})) {
      session.open_permalink(entry.text);
      state.open = false;
    }
    if (delete_button(name, entry)) gone = i;
  }
  text_field("bookmark-name", state.bookmark_name, "Name of this screen",
             {.width = ImGui::GetContentRegionAvail().x - button_width("Bookmark") - px(4)});
  ImGui::SameLine(0, px(4));
  if (button("bookmark", "Bookmark", Emphasis::plain,
             {.tooltip = "Keeps scene, options, camera and what is open under the name.",
              .disabled = state.bookmark_name.empty() ? "It needs a name." : ""}))
    keep_bookmark(session, state, state.bookmark_name);
  if (!gone) return;
  state.bookmarks.erase(state.bookmarks.begin() + static_cast<std::ptrdiff_t>(*gone));
  state.remember(bookmarks_key, kept_lines(state.bookmarks));
}

}  // namespace

void apply_preset(Session& session, Side side, const KeptEntry& preset) {
  Settings settings;
  try {
    std::istringstream words(preset.text);
    for (std::string word; words >> word;) parse_assignment(word, settings);
  } catch (const InputError& error) {
    return session.say(Message::Kind::error,
                       fmt::format("The preset \"{}\" does not fit: {}", preset.name, error.what()));
  }
  session.set_settings(side, settings, fmt::format("preset {} into {}", preset.name, letter_of(side)));
}

void keep_preset(Session& session, KeptState& state, Side side, const std::string& name) {
  std::string text;
  for (const std::string& assignment : changed_options(session.settings(side)))
    text += (text.empty() ? "" : " ") + assignment;
  if (!keep_entry(state.presets, name, text)) return;
  state.preset_name.clear();
  state.remember(presets_key, kept_lines(state.presets));
}

void keep_bookmark(Session& session, KeptState& state, const std::string& name) {
  if (!keep_entry(state.bookmarks, name, session.permalink())) return;
  state.bookmark_name.clear();
  state.remember(bookmarks_key, kept_lines(state.bookmarks));
}

void kept_panel(Session& session, KeptState& state) {
  if (!state.open || !session.has_scene()) return;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float width = std::min(px(600), display.x - px(40)), height = std::min(px(620), display.y - px(60));
  const Overlay window("##kept", {(display.x - width) / 2, (display.y - height) / 2}, {width, height},
                       ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                           ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings,
                       state.just_opened);
  const NameScope names("kept");
  {
    const FontScope title(Face::heading);
    ImGui::TextUnformatted("Presets and bookmarks");
  }
  ImGui::SameLine(ImGui::GetContentRegionMax().x - button_width("Close"));
  if (button("close", "Close", Emphasis::plain)) state.open = false;
  ImGui::Dummy({0, px(4)});
  presets(session, state);
  ImGui::Dummy({0, px(8)});
  bookmarks(session, state);
  if (window.left()) state.open = false;
}

std::vector<PaletteEntry> kept_entries(Session& session, const KeptState& state) {
  std::vector<PaletteEntry> entries;
  for (const KeptEntry& preset : state.presets)
    for (const Side side : both_sides)
      entries.push_back({fmt::format("preset/{}/{}", preset.name, side == Side::a ? "a" : "b"),
                         fmt::format("{} into {}", preset.name, letter_of(side)), "preset",
                         [&session, side, preset] { apply_preset(session, side, preset); }, preset.text});
  for (const KeptEntry& bookmark : state.bookmarks)
    entries.push_back({"bookmark/" + bookmark.name, bookmark.name, "bookmark",
                       [&session, text = bookmark.text] { session.open_permalink(text); }});
  return entries;
}

}  // namespace ps::gui
