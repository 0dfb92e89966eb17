#include "gui/shell/palette.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "base/check.h"
#include "gui/base/values.h"
#include "gui/platform/imgui_version.h"
#include "gui/shell/command_words.h"
#include "gui/shell/palette_fit.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

/// Enter takes the first picture in which a line changes something, with Shift the other one.
enum class Taken { first, other };

/// A line of the list: an action, or another entry.
struct Found {
  const Action* action = nullptr;
  const PaletteEntry* entry = nullptr;
  PaletteFit fit = PaletteFit::is_label;

  const std::string& name() const { return action ? action->name : entry->name; }
  const std::string& label() const { return action ? action->label : entry->label; }
  bool has_pictures() const { return entry && !entry->pictures.empty(); }
  /// Whether running it may change anything.
  bool changes() const {
    return !has_pictures() ||
           std::any_of(entry->pictures.begin(), entry->pictures.end(), [](const auto& one) { return one.changes; });
  }
  /// What it does to the picture that is taken.
  const PaletteEntry::ForPicture& picture(Taken taken) const {
    const auto& both = entry->pictures;
    const bool second = !both[0].changes && both[1].changes;
    return both[second != (taken == Taken::other) ? 1 : 0];
  }
};

constexpr const char* nothing_found = "No command, lesson, option, scene or experiment matches.";
constexpr std::size_t most_lines = 12;

/// Enter takes the first, so what would change nothing comes after what would, but for a mere likeness of letters. Of
/// labels that have it, those with the least besides come first.
auto rank(const Found& one) {
  const bool in_label = one.fit == PaletteFit::begins_label || one.fit == PaletteFit::in_label;
  return std::tuple(one.fit == PaletteFit::letters_in_order, !one.changes(), one.fit,
                    in_label ? one.label().size() : 0);
}

std::vector<Found> lines_for(const std::string& wanted, const Actions& actions,
                             const std::vector<PaletteEntry>& entries) {
  std::vector<Found> found;
  for (const Action& action : actions.all())
    if (const auto fit = action.run ? palette_fit(wanted, action.label, command_words(action.name)) : std::nullopt)
      found.push_back({.action = &action, .fit = *fit});
  if (!wanted.empty())
    for (const PaletteEntry& entry : entries)
      if (const auto fit = palette_fit(wanted, entry.label, entry.kind + ", " + entry.words))
        found.push_back({.entry = &entry, .fit = *fit});
  if (wanted.empty())
    return {found.begin(), found.begin() + static_cast<std::ptrdiff_t>(std::min(found.size(), most_lines))};
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return rank(a) < rank(b); });
  if (found.size() > most_lines) found.resize(most_lines);
  return found;
}

std::function<void()> run_of(const Actions& actions, const std::vector<PaletteEntry>& entries, const Found& one,
                             Taken taken) {
  if (one.action) return [&actions, name = one.action->name] { actions.run(name); };
  if (!one.entry->pictures.empty()) return one.picture(taken).run;
  const std::string& name = one.entry->leads_to;
  if (name.empty()) return one.entry->run;
  if (actions.find(name)) return [&actions, name] { actions.run(name); };
  for (const PaletteEntry& entry : entries)
    if (entry.name == name) return run_of(actions, entries, {.entry = &entry}, taken);
  PS_ASSERT(false, "what the palette leads to exists");
  return {};
}

/// Draws a line of the list; answers what a click on it runs.
std::function<void()> line(const Actions& actions, const std::vector<PaletteEntry>& entries, const Found& one,
                           bool selected) {
  std::function<void()> clicked;
  const bool dead = one.action && !actions.enabled(*one.action);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x, bottom = at.y + ImGui::GetFrameHeight();
  const std::size_t pictures = one.action ? 0 : one.entry->pictures.size();
  const float chip = button_width("A"), gap = ImGui::GetStyle().ItemSpacing.x;
  const float left_of_chips = right - static_cast<float>(pictures) * (chip + gap);
  if (ImGui::Selectable(("##" + one.name()).c_str(), selected, 0, {left_of_chips - at.x, bottom - at.y}) && !dead)
    clicked = run_of(actions, entries, one, Taken::first);
  controls().record(one.name(), one.label(), !dead);
  std::string note = one.action ? actions.key_text(one.action->name) : one.entry->kind;
  if (pictures > 0) note = one.picture(Taken::first).effect;
  const float note_left = left_of_chips - text_width(note, Face::mono);
  const float y = at.y + ImGui::GetStyle().FramePadding.y;
  draw_text({note_left, y}, {left_of_chips, bottom}, note, palette().text, 0, Face::mono);
  draw_text({at.x, y}, {note_left - px(12), bottom}, one.label(), dead ? palette().text_disabled : palette().text, 0);
  for (std::size_t i = 0; i < pictures; ++i) {
    const PaletteEntry::ForPicture& by = one.entry->pictures[i];
    ImGui::SameLine(0, gap);
    const std::string name = one.name() + (by.picture == 'A' ? "/a" : "/b");
    if (button(name, std::string(1, by.picture), by.changes ? Emphasis::plain : Emphasis::quiet,
               {.tooltip = by.effect}))
      clicked = by.run;
  }
  return clicked;
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
  ImGui::SetNextItemWidth(-1);
  if (just_opened_) ImGui::SetKeyboardFocusHere();
  ImGui::PushStyleColor(ImGuiCol_FrameBg, palette().panel);
  forget_edits_before("##text");
  const bool enter = ImGui::InputTextWithHint("##text", "Type a command, a lesson, an option or a value", &text_,
                                              ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::PopStyleColor();
  if (ImGui::IsItemEdited()) selected_ = 0;
  controls().record("text", text_);

  const std::vector<Found> found = lines_for(text_, actions, entries_);
  const int count = static_cast<int>(found.size());
  if (key_pressed(Key::down)) ++selected_;
  if (key_pressed(Key::up)) --selected_;
  selected_ = count > 0 ? (selected_ + count) % count : 0;
  std::function<void()> chosen;
  for (int i = 0; i < count; ++i)
    if (auto run = line(actions, entries_, found[static_cast<std::size_t>(i)], i == selected_)) chosen = std::move(run);
  if (count > 0 && found[static_cast<std::size_t>(selected_)].has_pictures())
    quiet_text("Enter does it in the picture that is named, Shift+Enter in the other one.");
  if (count == 0) value_paragraph("nothing-found", nothing_found, {.quiet = true});
  values().publish("palette/first", count > 0 ? found[0].name() : std::string());
  if (enter && count > 0)
    chosen = run_of(actions, entries_, found[static_cast<std::size_t>(selected_)],
                    ImGui::GetIO().KeyShift ? Taken::other : Taken::first);
  const bool lost = !just_opened_ && !ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
  if (lost || enter || chosen || key_pressed(Key::escape)) open_ = false;
  just_opened_ = false;
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  if (chosen) chosen();
}

}  // namespace ps::gui
