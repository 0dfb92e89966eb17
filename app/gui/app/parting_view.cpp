#include "gui/app/parting_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "gui/widgets/draw.h"
#include "inspect/describe.h"

namespace ps::gui {
namespace {

constexpr int most_rows = 200;  // drawn at once; the two trees show the rest, page by page
constexpr double indent_step = 10, letter_width = 18;

void compare(const Session& session, PartingViewState& state,
             const std::array<std::shared_ptr<const PixelStory>, 2>& stories) {
  if (state.told == stories) return;
  state.told = stories;
  const StorySide a{*stories[0], session.settings(Side::a)}, b{*stories[1], session.settings(Side::b)};
  state.parting = find_parting(session.scene(), a, b);
  state.rows = align_stories(*stories[0], *stories[1], session.scene());
  state.reveal = true;
}

void sentence(const Parting& parting) {
  if (parting.cause != PartingCause::none) {
    const FontScope font(Face::small);
    ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
    ImGui::TextUnformatted("cause");
    ImGui::PopStyleColor();
    ImGui::SameLine(0, px(8));
    std::string words(parting_cause_key(parting.cause));
    std::replace(words.begin(), words.end(), '-', ' ');
    const FontScope bold(Face::bold);
    value_text("cause", words);
  }
  const FontScope font(Face::heading);
  ImGui::PushTextWrapPos(0);
  value_text("sentence", parting.sentence);
  ImGui::PopTextWrapPos();
}

std::string text_of(const PixelStory& story, int event, const Scene& scene) {
  return event < 0 ? std::string() : describe(story.events[static_cast<std::size_t>(event)], scene);
}

/// One line of a row: its letter, then what happened there.
void line(ImVec2 at, float right, Side side, std::string_view words) {
  const auto& ink = side == Side::a ? palette().a_text : palette().b_text;
  const float height = ImGui::GetTextLineHeight();
  draw_text(at, {at.x + px(letter_width), at.y + height}, side == Side::a ? "A" : "B", ink, 0);
  draw_text({at.x + px(letter_width), at.y}, {right, at.y + height}, words, palette().text, 0);
}

/// A step of the two stories. Answers whether it was clicked.
bool step(int number, const AlignedRow& row, bool parts_here, bool selected, PartingViewState& state,
          const Scene& scene) {
  const std::string a = text_of(*state.told[0], row.a, scene), b = text_of(*state.told[1], row.b, scene);
  const std::string name = fmt::format("row-{}", number);
  const float line_height = ImGui::GetTextLineHeight();
  const bool in_both = row.a >= 0 && row.b >= 0;
  const float height = in_both && !row.same ? 2 * line_height : line_height;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x;
  const bool clicked = ImGui::Selectable(("##" + name).c_str(), selected, 0, {0, height + px(4)});
  controls().record(name, row.same ? a : a + " | " + b);
  tooltip(row.same    ? "The same in both:\n" + a
          : row.b < 0 ? "Only in A:\n" + a
          : row.a < 0 ? "Only in B:\n" + b
                      : "A: " + a + "\nB: " + b);
  const float left = at.x + px(8) + px(indent_step) * static_cast<float>(std::min(row.depth, 8));
  if (parts_here) {
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + px(4), at.y + height + px(4)},
                                              colour_u32(palette().attention));
    if (state.reveal) ImGui::SetScrollHereY(0.3F);
  }
  const float top = at.y + px(2);
  if (row.same)
    draw_text({left, top}, {right, top + line_height}, a, palette().text_quiet, 0);
  else if (row.a >= 0)
    line({left, top}, right, Side::a, a);
  if (!row.same && row.b >= 0) line({left, in_both ? top + line_height : top}, right, Side::b, b);
  return clicked;
}

/// The row that shows `parting`, or -1.
int row_of(const PartingViewState& state) {
  for (std::size_t i = 0; i < state.rows.size(); ++i) {
    const AlignedRow& row = state.rows[i];
    if (state.parting.cause == PartingCause::none) return -1;
    if ((state.parting.event_a >= 0 && row.a == state.parting.event_a) ||
        (state.parting.event_a < 0 && row.b == state.parting.event_b))
      return static_cast<int>(i);
  }
  return -1;
}

void steps(Session& session, PartingViewState& state, std::array<StoryCursor, 2>& cursors) {
  const int parts_at = row_of(state);
  int shown = 0, equal = 0;
  for (std::size_t i = 0; i < state.rows.size() && shown < most_rows; ++i) {
    const AlignedRow& row = state.rows[i];
    const bool parts_here = static_cast<int>(i) == parts_at;
    if (row.same && !state.equal_steps && !parts_here) {
      ++equal;
      continue;
    }
    ++shown;
    const bool selected = (row.a >= 0 && cursors[0].selected == row.a) || (row.b >= 0 && cursors[1].selected == row.b);
    if (step(static_cast<int>(i), row, parts_here, selected, state, session.scene())) {
      if (row.a >= 0) cursors[0] = {row.a, true, row.a / events_per_page};
      if (row.b >= 0) cursors[1] = {row.b, true, row.b / events_per_page};
    }
  }
  state.reveal = false;
  ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
  if (equal > 0) ImGui::TextWrapped("%d steps are the same in both.", equal);
  if (shown == most_rows) ImGui::TextWrapped("The first %d are shown.", most_rows);
  ImGui::PopStyleColor();
}

}  // namespace

void parting_view(Session& session, PartingViewState& state,
                  const std::array<std::shared_ptr<const PixelStory>, 2>& stories,
                  std::array<StoryCursor, 2>& cursors) {
  const NameScope scope("parting");
  if (!stories[0] || !stories[1]) {
    ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
    ImGui::TextWrapped("Both stories are needed to compare them.");
    ImGui::PopStyleColor();
    return;
  }
  compare(session, state, stories);
  sentence(state.parting);
  ImGui::Spacing();
  if (state.parting.cause != PartingCause::none || state.equal_steps)
    toggle("equal-steps", "Equal steps too", state.equal_steps);
  ImGui::Spacing();
  steps(session, state, cursors);
}

}  // namespace ps::gui
