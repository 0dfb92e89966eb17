#include "gui/shell/palette.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>
#include <tuple>

#include "base/word_search.h"
#include "gui/base/values.h"
#include "gui/platform/imgui_version.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

/// How well a line fits what was typed. The best come first.
enum class Fit { label_has_it, words_have_it, letters_in_order };

/// A line of the list.
struct Found {
  const Action* action = nullptr;  ///< null for another entry
  std::string name, label, note;
  Fit fit = Fit::label_has_it;
  bool changes = true;  ///< as of PaletteEntry
};

constexpr const char* nothing_found = "No command, lesson, option, scene or experiment matches.";

bool in_one_piece(const std::string& wanted, const std::string& label) {
  return std::search(label.begin(), label.end(), wanted.begin(), wanted.end(), [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
         }) != label.end();
}
std::optional<Fit> fit_of(const std::string& wanted, const std::string& label, std::string_view words) {
  if (in_one_piece(wanted, label)) return Fit::label_has_it;
  if (has_words(wanted, {label, words})) return Fit::words_have_it;
  if (letters_in_order(wanted, label)) return Fit::letters_in_order;
  return {};
}

}  // namespace

void CommandPalette::open() {
  open_ = just_opened_ = true;
  text_.clear();
  selected_ = 0;
}

void CommandPalette::draw(const Actions& actions) {
  values().publish("palette/open", open_);
  if (!open_) return;
  if (just_opened_) entries_ = actions.more();
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float width = std::min(px(640), display.x - px(40));
  ImGui::SetNextWindowPos({(display.x - width) / 2, std::min(px(90), display.y / 8)});
  ImGui::SetNextWindowSize({width, 0});
  if (just_opened_) ImGui::SetNextWindowFocus();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(6));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette().field);
  ImGui::Begin("##palette", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
  const NameScope names("palette");
  std::string chosen;
  ImGui::SetNextItemWidth(-1);
  if (just_opened_) ImGui::SetKeyboardFocusHere();
  ImGui::PushStyleColor(ImGuiCol_FrameBg, palette().panel);
  forget_edits_before("##text");
  const bool enter = ImGui::InputTextWithHint("##text", "Type a command, a lesson, an option or a value", &text_,
                                              ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::PopStyleColor();
  if (ImGui::IsItemEdited()) selected_ = 0;
  controls().record("text", text_);

  std::vector<Found> found;
  for (const Action& action : actions.all())
    if (const auto fit = action.run ? fit_of(text_, action.label, {}) : std::nullopt)
      found.push_back({&action, action.name, action.label, actions.key_text(action.name), *fit});
  if (!text_.empty())
    for (const PaletteEntry& entry : entries_)
      if (const auto fit = fit_of(text_, entry.label, entry.words))
        found.push_back({nullptr, entry.name, entry.label, entry.kind, *fit, entry.changes});
  // Enter takes the first, so what would change nothing comes after what would, but for a mere likeness of letters.
  const auto rank = [](const Found& one) {
    return std::tuple(one.fit == Fit::letters_in_order, !one.changes, one.fit);
  };
  std::stable_sort(found.begin(), found.end(), [&](const Found& a, const Found& b) { return rank(a) < rank(b); });
  constexpr std::size_t most = 12;
  if (found.size() > most) found.resize(most);
  const int count = static_cast<int>(found.size());
  if (key_pressed(Key::down)) ++selected_;
  if (key_pressed(Key::up)) --selected_;
  selected_ = count > 0 ? (selected_ + count) % count : 0;
  for (int i = 0; i < count; ++i) {
    const Found& one = found[static_cast<std::size_t>(i)];
    const bool dead = one.action && !actions.enabled(*one.action);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float right = at.x + ImGui::GetContentRegionAvail().x, bottom = at.y + ImGui::GetTextLineHeight();
    if (ImGui::Selectable(("##" + one.name).c_str(), i == selected_) && !dead) chosen = one.name;
    controls().record(one.name, one.label, !dead);
    const float note_left = right - text_width(one.note, Face::mono);
    draw_text({note_left, at.y}, {right, bottom}, one.note, palette().text, 0, Face::mono);
    draw_text(at, {note_left - px(12), bottom}, one.label, dead ? palette().text_disabled : palette().text, 0);
  }
  if (count == 0) value_paragraph("nothing-found", nothing_found, {.quiet = true});
  if (enter && count > 0) chosen = found[static_cast<std::size_t>(selected_)].name;
  const bool lost = !just_opened_ && !ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
  if (lost || enter || !chosen.empty() || key_pressed(Key::escape)) open_ = false;
  just_opened_ = false;
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  if (chosen.empty()) return;
  if (actions.find(chosen))
    actions.run(chosen);
  else
    for (const PaletteEntry& entry : entries_)
      if (entry.name == chosen) return entry.run();
}

}  // namespace ps::gui
