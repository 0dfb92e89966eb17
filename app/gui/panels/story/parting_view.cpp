#include "gui/panels/story/parting_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/enumerators.h"
#include "base/sentence.h"
#include "gui/panels/story/story_rows.h"
#include "gui/widgets/draw.h"
#include "inspect/describe.h"

namespace ps::gui {
namespace {

constexpr int most_rows = 200;  // drawn at once; the two trees show the rest, page by page
constexpr double parting_indent = 10, letter_width = 18;
constexpr double room_for_both = 640;  // width for A and B beside each other

void compare(const Session& session, PartingViewState& state,
             const std::array<std::shared_ptr<const PixelStory>, 2>& stories) {
  if (state.shown_stories == stories) return;
  state.shown_stories = stories;
  const StorySide a{*stories[0], session.settings(Side::a)}, b{*stories[1], session.settings(Side::b)};
  state.parting = find_parting(session.scene(), a, b);
  state.rows = align_stories(*stories[0], *stories[1], session.scene());
  state.reveal = true;
}

void sentence(const Parting& parting) {
  if (parting.cause != PartingCause::none) {
    show_text("cause", {Face::small, true});
    ImGui::SameLine(0, px(8));
    std::string words(enumerator_key(parting.cause));
    std::replace(words.begin(), words.end(), '-', ' ');
    value_text("cause", words, {Face::bold});
  }
  headline("sentence", parting.sentence, ": ");
}

std::string text_of(const PixelStory& story, int event, const Scene& scene) {
  return event < 0 ? std::string() : describe(story.events[static_cast<std::size_t>(event)], scene);
}

/// The text of a step on one side, after the side's letter.
struct Words {
  std::string lines;
  Side side = Side::a;
  ImVec2 at{};  ///< relative to the row's upper left corner
};

void draw(const Words& words, ImVec2 row, const ImVec4& ink) {
  const ImVec2 at{row.x + words.at.x, row.y + words.at.y};
  side_bar(*ImGui::GetWindowDrawList(), {at.x - px(6), at.y + px(2)},
           {at.x - px(3), at.y + ImGui::GetTextLineHeight() - px(2)}, words.side);
  draw_lines(at, words.side == Side::a ? "A" : "B", palette().text);
  draw_lines({at.x + px(letter_width), at.y}, words.lines, ink);
}

/// A step of the two stories: A above B, or where there is room beside it. Answers whether it was clicked.
bool step(int number, const AlignedRow& row, bool parts_here, bool selected, PartingViewState& state,
          const Scene& scene) {
  const float room = ImGui::GetContentRegionAvail().x, indent = px(8 + parting_indent * std::min(row.depth, 8));
  const bool beside = room >= px(room_for_both);
  const float column = beside ? std::floor((room - indent) / 2) : room - indent;
  const std::array texts{text_of(*state.shown_stories[0], row.a, scene),
                         text_of(*state.shown_stories[1], row.b, scene)};
  std::vector<Words> parts;
  float height = 0;
  for (const Side side : both_sides) {
    const std::string& text = texts[index_of(side)];
    if (text.empty() || (!beside && side == Side::b && row.same && text == texts[0])) continue;
    Words words{in_lines(text, column - px(letter_width + 4)), side, {indent, 0}};
    if (beside)
      words.at.x += side == Side::b ? column : 0;
    else
      words.at.y = height;
    height = beside ? std::max(height, text_height(words.lines)) : height + text_height(words.lines);
    parts.push_back(std::move(words));
  }
  const std::string name = fmt::format("row-{}", number);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float full = height + px(6);
  if (parts_here) {
    auto& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + room, at.y + full}, colour_u32(palette().attention, 0.15));
    attention_bar(list, at, {at.x + px(4), at.y + full});
  }
  const bool clicked = ImGui::Selectable(("##" + name).c_str(), selected, 0, {0, full});
  controls().record(name, row.same && texts[0] == texts[1] ? texts[0] : texts[0] + " | " + texts[1]);
  if (parts_here && state.reveal) ImGui::SetScrollHereY(0.3F);
  for (const Words& words : parts) draw(words, {at.x, at.y + px(3)}, row.same ? palette().text_quiet : palette().text);
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

/// Whether a step that only one side took says something to people: not what rays and pixels passed by.
bool worth_a_row(const PartingViewState& state, const AlignedRow& row) {
  if (row.a >= 0 && row.b >= 0) return true;
  const Event& event = row.a >= 0 ? state.shown_stories[0]->events[static_cast<std::size_t>(row.a)]
                                  : state.shown_stories[1]->events[static_cast<std::size_t>(row.b)];
  return event_weight(event) != EventWeight::quiet && !std::holds_alternative<RejectEvent>(event.data);
}

void steps(Session& session, PartingViewState& state) {
  const int parts_at = row_of(state), selected_a = session.selected_event(Side::a),
            selected_b = session.selected_event(Side::b);
  int shown = 0, equal = 0, quiet = 0;
  for (std::size_t i = 0; i < state.rows.size() && shown < most_rows; ++i) {
    const AlignedRow& row = state.rows[i];
    const bool parts_here = static_cast<int>(i) == parts_at;
    if (!state.all_steps && !parts_here && (row.same || !worth_a_row(state, row))) {
      ++(row.same ? equal : quiet);
      continue;
    }
    ++shown;
    const bool selected = (row.a >= 0 && selected_a == row.a) || (row.b >= 0 && selected_b == row.b);
    if (step(static_cast<int>(i), row, parts_here, selected, state, session.scene()))
      session.navigate([&](Document& document) {
        document.events = {row.a, row.b};
        document.story.until_event = false;
        // Space and microscope show the side that took the step.
        if (event_of(document, document.picked) < 0) document.picked = other_side(document.picked);
      });
  }
  state.reveal = false;
  if (equal > 0) quiet_text(fmt::format("{} steps are the same in both.", equal));
  if (quiet > 0) quiet_text(fmt::format("{} more are boxes and triangles that the rays of A or B missed.", quiet));
  if (shown == most_rows) quiet_text(fmt::format("The first {} are shown.", most_rows));
}

}  // namespace

void headline(const std::string& name, const std::string& text, std::string_view divider) {
  const std::size_t end = text.find(divider);
  show_paragraph(text.substr(0, end), {Face::heading});
  const ImVec2 low = ImGui::GetItemRectMin();
  if (end != std::string::npos) show_paragraph(begun_large(text.substr(text.find(' ', end) + 1)));
  controls().record(name, low, ImGui::GetItemRectMax(), text);
}

void parting_view(Session& session, PartingViewState& state,
                  const std::array<std::shared_ptr<const PixelStory>, 2>& stories) {
  const NameScope scope("parting");
  if (session.picture_b())
    return quiet_text("B is a picture file, which has no story. What it has less or more here is under B; what it "
                      "lacks as a whole is under Measure, Why.");
  if (!stories[0] || !stories[1]) return quiet_text("Both stories are needed to compare them.");
  compare(session, state, stories);
  sentence(state.parting);
  ImGui::Spacing();
  if (state.parting.cause != PartingCause::none || state.all_steps) toggle("equal-steps", "All steps", state.all_steps);
  ImGui::Spacing();
  ImGui::BeginChild("steps");  // what it comes down to stays in sight
  steps(session, state);
  ImGui::EndChild();
}

}  // namespace ps::gui
