#include "gui/panels/kept/kept_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "base/check.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/shorten.h"
#include "gui/widgets/text_field.h"
#include "gui/widgets/widgets.h"
#include "options/option.h"

namespace ps::gui {
namespace {

constexpr const char *presets_key = "app/presets", *bookmarks_key = "app/bookmarks";

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

/// Sets all options of a side as the preset has them. An entry that does not fit this version becomes a message.
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

}  // namespace

void KeptPanel::presets() {
  heading("Presets: all options of a picture");
  std::optional<std::size_t> gone;
  const float buttons = button_width("Into A") + button_width("Into B") + button_width("Delete") + px(8) +
                        ImGui::GetStyle().ItemSpacing.x;
  for (std::size_t i = 0; i < presets_.size(); ++i) {
    const KeptEntry& entry = presets_[i];
    const std::string name = fmt::format("preset/{}", i);
    entry_name(entry, buttons);
    for (const Side side : both_sides) {
      if (side == Side::b) ImGui::SameLine(0, px(4));
      if (button(fmt::format("{}/{}", name, side == Side::a ? "a" : "b"), fmt::format("Into {}", letter_of(side)),
                 Emphasis::plain, {.tooltip = entry.text.empty() ? "All options at their defaults." : entry.text}))
        apply_preset(session_, side, entry);
    }
    if (delete_button(name, entry)) gone = i;
  }
  const float fields = button_width("Keep A's") + button_width("Keep B's") + px(8);
  text_field("preset-name", preset_name_, "Name of a preset",
             {.width = ImGui::GetContentRegionAvail().x - fields - px(4)});
  const std::string_view nameless = preset_name_.empty() ? "It needs a name." : "";
  for (const Side side : both_sides) {
    ImGui::SameLine(0, px(4));
    if (button(side == Side::a ? "keep-a" : "keep-b", fmt::format("Keep {}'s", letter_of(side)), Emphasis::plain,
               {.tooltip = "Keeps all options of this picture under the name.", .disabled = nameless}))
      keep_preset(side);
  }
  if (!gone) return;
  presets_.erase(presets_.begin() + static_cast<std::ptrdiff_t>(*gone));
  host_.remember_lines(presets_key, kept_lines(presets_));
}

void KeptPanel::bookmarks() {
  heading("Bookmarks: the whole screen");
  std::optional<std::size_t> gone;
  const float buttons = button_width("Open") + button_width("Delete") + px(4) + ImGui::GetStyle().ItemSpacing.x;
  for (std::size_t i = 0; i < bookmarks_.size(); ++i) {
    const KeptEntry& entry = bookmarks_[i];
    const std::string name = fmt::format("bookmark/{}", i);
    entry_name(entry, buttons);
    if (button(name + "/open", "Open", Emphasis::plain, {.tooltip = "Shows the screen as it was then."})) {
      session_.open_permalink(entry.text);
      open_ = false;
    }
    if (delete_button(name, entry)) gone = i;
  }
  text_field("bookmark-name", bookmark_name_, "Name of this screen",
             {.width = ImGui::GetContentRegionAvail().x - button_width("Bookmark") - px(4)});
  ImGui::SameLine(0, px(4));
  if (button("bookmark", "Bookmark", Emphasis::plain,
             {.tooltip = "Keeps scene, options, camera and what is open under the name.",
              .disabled = bookmark_name_.empty() ? "It needs a name." : ""}))
    keep_bookmark();
  if (!gone) return;
  bookmarks_.erase(bookmarks_.begin() + static_cast<std::ptrdiff_t>(*gone));
  host_.remember_lines(bookmarks_key, kept_lines(bookmarks_));
}

void KeptPanel::keep_preset(Side side) {
  std::string text;
  for (const std::string& assignment : changed_options(session_.settings(side)))
    text += (text.empty() ? "" : " ") + assignment;
  if (!keep_entry(presets_, preset_name_, text)) return;
  preset_name_.clear();
  host_.remember_lines(presets_key, kept_lines(presets_));
}

void KeptPanel::keep_bookmark() {
  if (!keep_entry(bookmarks_, bookmark_name_, session_.permalink())) return;
  bookmark_name_.clear();
  host_.remember_lines(bookmarks_key, kept_lines(bookmarks_));
}

KeptPanel::KeptPanel(const PanelHost& host)
    : Sheet(host, "kept", {"Presets and bookmarks", {600, 0}}), presets_(parse_kept(host.remembered(presets_key))),
      bookmarks_(parse_kept(host.remembered(bookmarks_key))) {}

void KeptPanel::add_actions(Actions& actions) {
  ActionGroup(actions, "Edit", [this] {
    return session_.has_scene();
  }).add("kept", "Presets and bookmarks: keep options or the screen under a name", "M", [this] { open(); });
}

void KeptPanel::draw_sheet() {
  presets();
  ImGui::Dummy({0, px(8)});
  bookmarks();
}

void KeptPanel::add_entries(std::vector<PaletteEntry>& entries) {
  for (const KeptEntry& preset : presets_) {
    PaletteEntry& entry = entries.emplace_back();
    entry.name = "preset/" + preset.name;
    entry.label = "Preset: " + preset.name;
    entry.words = preset.name + ", " + preset.text;
    for (const Side side : both_sides)
      entry.pictures.push_back({letter_of(side), fmt::format("apply to {}", letter_of(side)), true,
                                [this, side, preset] { apply_preset(session_, side, preset); }});
  }
  for (const KeptEntry& bookmark : bookmarks_)
    entries.push_back({"bookmark/" + bookmark.name, bookmark.name, "bookmark",
                       [this, text = bookmark.text] { session_.open_permalink(text); }});
}

}  // namespace ps::gui
