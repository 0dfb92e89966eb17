#include "gui/panels/story/listing_code.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/base/values.h"
#include "gui/panels/story/code_lines.h"
#include "gui/panels/story/shown_field.h"
#include "gui/theme/projected_type.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/redraw.h"
#include "gui/widgets/shorten.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr double number_room = 34;
constexpr double least_values = 300;  // beside the code; in less room they go below it

std::string instance_text(const ListingRow& row) { return fmt::format("{} {}/{}", row.instance, row.place, row.count); }

float stepper_width(const ListingRow& row) { return text_width(instance_text(row)) + 2 * px(20); }

/// The instance of a loop, with arrows to go to its neighbours.
int stepper(const ListingRow& row, std::size_t index) {
  int by = 0;
  const float line = ImGui::GetTextLineHeight();
  const auto arrow = [&](const char* part, const char* sign, int direction) {
    const std::string name = fmt::format("line-{}/{}", row.number, part);
    ImGui::PushID(static_cast<int>(index));
    if (word_button(name, sign, px(20), {.height = line}, {})) by = direction;
    ImGui::PopID();
    controls().record(name, sign);
  };
  arrow("previous", "‹", -1);
  ImGui::SameLine(0, 0);
  const std::string text = instance_text(row);
  show_text(whole_words(text, ImGui::GetContentRegionAvail().x - px(20)));
  controls().record(fmt::format("line-{}/instance", row.number), text);
  ImGui::SameLine(0, 0);
  arrow("next", "›", 1);
  return by;
}

/// Which number of a text of one line, such as "(0.5, 1, 2)", is under the pointer; -1 = it has but one.
int component_under_pointer(const std::string& text) {
  if (text.find(',') == std::string::npos) return -1;
  const float into = (ImGui::GetIO().MousePos.x - ImGui::GetItemRectMin().x) / text_width("0");
  const auto signs = static_cast<std::ptrdiff_t>(std::clamp(into, 0.f, static_cast<float>(text.size())));
  return static_cast<int>(std::count(text.begin(), text.begin() + signs, ','));
}

/// The value, which can be clicked where the picture can show it for all pixels.
void value_text_of(const ListingRow& row, const ListingValue& value, const LineMarks& marks, float room,
                   std::optional<ListingStep>& clicked) {
  show_text(in_lines(value.value, room));
  if (!marks.can_show || value.watch < 0) return;
  controls().record(fmt::format("line-{}/{}", row.number, value.name), value.value);
  if (!ImGui::IsItemHovered()) return;
  const int component = component_under_pointer(value.value);
  if (marks.can_show(value.watch, component) && number_to_show({}))
    clicked = {.watch = value.watch, .component = component};
}

/// `left`: where further lines of values begin. Answers the value that was clicked.
std::optional<ListingStep> values(const ListingRow& row, const LineMarks& marks, float left) {
  std::optional<ListingStep> clicked;
  std::string all;
  const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
  bool first = true;
  for (const ListingValue& value : row.values) {
    const std::string name = value.name + " = ";
    const float needed = text_width(name) + text_width(value.value);
    if (!first) {
      ImGui::SameLine(0, px(14));
      if (ImGui::GetCursorScreenPos().x + needed > right) ImGui::NewLine();
    }
    if (ImGui::GetCursorScreenPos().x < left || ImGui::GetCursorScreenPos().x + needed > right) {
      if (first && row.loops) ImGui::NewLine();  // the arrows are there
      ImGui::SetCursorScreenPos({left, ImGui::GetCursorScreenPos().y});
    }
    first = false;
    show_text(name, {.quiet = true});
    if (left + needed <= right)
      ImGui::SameLine(0, 0);
    else
      ImGui::SetCursorScreenPos({left, ImGui::GetCursorScreenPos().y});  // it has lines of its own
    value_text_of(row, value, marks, right - ImGui::GetCursorScreenPos().x, clicked);
    all += (all.empty() ? "" : ", ") + value.name + " = " + value.value;
  }
  if (!row.values.empty()) controls().record(fmt::format("line-{}", row.number), all);
  return clicked;
}

bool has_values(const ListingRow& row) { return row.loops || !row.values.empty(); }

struct ListingColumns {
  float code = 0;       ///< where the code begins
  float values = 0;     ///< where the values begin; 0 = below the code
  float character = 0;  ///< width of one
};

ListingColumns columns_for(const std::vector<ListingRow>& rows, float room) {
  std::size_t longest = 0;  // of the lines that have values; the others may continue below the values
  for (const ListingRow& row : rows)
    if (has_values(row)) longest = std::max(longest, row.text.size());
  ListingColumns columns;
  columns.character = text_width("0");
  const std::size_t digits = rows.empty() ? 0 : std::max<std::size_t>(3, fmt::formatted_size("{}", rows.back().number));
  columns.code = std::max(px(number_room), columns.character * static_cast<float>(digits) + px(12));
  const float wanted = columns.code + columns.character * static_cast<float>(longest + 2);
  if (room - wanted >= px(least_values)) columns.values = wanted;
  return columns;
}

/// One line of code with what it had. Answers what was clicked.
std::optional<ListingStep> draw_row(const ListingRow& row, std::size_t index, const ListingColumns& columns,
                                    const LineMarks& marks) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight();
  const bool valued = has_values(row);
  const bool aside = columns.values > 0 && valued;
  const float code_width = (aside ? columns.values : room) - columns.code;
  const auto signs = static_cast<std::size_t>(std::max(12.f, std::floor(code_width / columns.character)));
  const std::string code = aside ? row.text : code_lines(row.text, signs);
  const float code_height = std::max(height, text_height(code));
  const float code_end = at.x + (columns.values > 0 && valued ? columns.values : room);
  if (valued)
    ImGui::GetWindowDrawList()->AddRectFilled({at.x + columns.code - px(4), at.y}, {code_end, at.y + code_height},
                                              colour_u32(palette().field), px(2));
  if (!row.text.empty()) line_ground(row.number, {code_end - at.x, code_height}, marks);
  draw_text(at, {at.x + columns.code - px(8), at.y + height}, fmt::format("{}", row.number), palette().text_quiet, 1);
  const auto start = row.text.find_first_not_of(' ');
  const bool comment = start != std::string::npos && row.text.compare(start, 2, "//") == 0;
  const ImVec4& ink = row.dimmed ? palette().text_disabled : comment ? palette().text_quiet : palette().text;
  draw_lines({at.x + columns.code, at.y}, code, ink);
  int by = 0;
  const float indent = columns.character * static_cast<float>((start == std::string::npos ? 0 : start) + 2);
  const float values_at = columns.values > 0 ? columns.values + px(8) : columns.code + indent;
  if (aside) {
    ImGui::SetCursorScreenPos({at.x + values_at, at.y});
  } else {
    ImGui::Dummy({room, code_height});
    if (!valued) return {};
    const float needed = row.loops ? stepper_width(row) : 0;
    ImGui::SetCursorScreenPos(
        {at.x + std::max(columns.code, std::min(values_at, room - needed)), ImGui::GetCursorScreenPos().y});
  }
  if (row.loops) {
    by = stepper(row, index);
    if (!row.values.empty()) ImGui::SameLine(0, px(14));
  }
  const auto clicked = values(row, marks, at.x + (aside ? values_at : columns.code));
  return by != 0 ? ListingStep{index, by} : clicked;
}

/// Small print where a line would be broken otherwise, but not for the last row behind a projector.
Face code_face(const std::vector<ListingRow>& rows, float room) {
  const FontScope font(Face::mono);
  std::size_t longest = 0;
  for (const ListingRow& row : rows) longest = std::max(longest, row.text.size());
  const float wanted = px(number_room) + text_width("0") * static_cast<float>(longest);
  return wanted <= room || ProjectedType::in_use() ? Face::mono : Face::mono_small;
}

/// Where the routine begins that has this line, with the remarks above it: what is not indented, and ends nothing.
std::size_t routine_of(const std::vector<ListingRow>& rows, std::size_t row) {
  const auto begins = [&](const std::string& text) { return !text.empty() && text[0] != ' ' && text[0] != '}'; };
  std::size_t head = row;
  while (head > 0 && !begins(rows[head].text)) --head;
  while (head > 0 && rows[head - 1].text.starts_with("//")) --head;
  return head;
}

/// The line where the routine begins that is to be seen first, with the remarks above it.
std::optional<std::size_t> wanted_routine(const std::vector<ListingRow>& rows, const LineMarks& marks) {
  const std::string& name = marks.routine;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string& text = rows[i].text;
    if (name.empty() && marks.within > 0 && rows[i].number == marks.within) return routine_of(rows, i);
    if (!name.empty() && !text.empty() && text[0] != ' ' && text[0] != '/' &&
        text.find(' ' + name + '(') != std::string::npos)
      return routine_of(rows, i);
  }
  return {};
}

/// Above the line that is looked for, part of the height; the head of its routine may take more.
constexpr float above_line = 0.15f, most_above_line = 0.6f;

/// Heights in the window's content.
struct LookedFor {
  float line = 0;
  float head = 0;                ///< where its routine begins
  std::optional<float> routine;  ///< where the one begins that is to be seen first
};

/// Scrolls so that the line, and if they fit those from the head of its routine on, are in sight.
void scroll_to(const LookedFor& places) {
  const float height = ImGui::GetWindowHeight();
  float top = places.line - above_line * height;
  if (places.line - places.head < most_above_line * height) top = std::min(top, places.head);
  // One that begins in the upper part is seen as well.
  if (places.routine && (*places.routine < top || *places.routine > top + most_above_line * height / 2))
    top = *places.routine;
  ImGui::SetScrollY(std::max(0.0f, top));
}

/// Whether to scroll to the line that is looked for: in two frames from when that was asked for, as lines may break
/// elsewhere once the bar to scroll with is there; and where the type has another size than before.
bool keeps_revealing(bool asked) {
  const int type = static_cast<int>(ImGui::GetFontSize());
  asked |= std::exchange(*ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("type"), type), type) != type;
  int& frames = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("reveal"));
  if (asked) frames = 2;
  if (frames == 0) return false;
  if (--frames > 0) redraw_after(0);
  return true;
}

/// Between lines: nothing where that makes a screenful of them.
float line_spacing() {
  constexpr float screenful = 24;
  const float line = ImGui::GetTextLineHeight(), height = ImGui::GetWindowHeight(), usual = px(1);
  return height >= screenful * line && height < screenful * (line + usual) ? 0 : usual;
}

}  // namespace

std::optional<ListingStep> listing_code(const std::vector<ListingRow>& rows, bool reveal, const LineMarks& marks) {
  std::optional<ListingStep> step;
  const auto first = std::find_if(rows.begin(), rows.end(), [&](const ListingRow& row) {
    if (marks.first > 0) return row.number == marks.first;
    if (!marks.faults.empty()) return row.number == marks.faults.begin()->first;
    return marks.marked ? row.number == marks.marked->number : has_values(row);
  });
  ImGui::BeginChild("code");
  {
    const FontScope font(code_face(rows, ImGui::GetContentRegionAvail().x));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(4), line_spacing()});
    const bool reveals = keeps_revealing(reveal);
    gui::values().publish("listing/lines",
                          static_cast<int>(ImGui::GetWindowHeight() / ImGui::GetTextLineHeightWithSpacing()));
    const ListingColumns columns = columns_for(rows, ImGui::GetContentRegionAvail().x);
    const auto target = static_cast<std::size_t>(first - rows.begin());
    const bool alone = marks.first > 0 || marks.marked || !marks.faults.empty();
    const std::size_t head = alone || first == rows.end() ? target : routine_of(rows, target);
    const auto named = marks.marked ? std::nullopt : wanted_routine(rows, marks);
    LookedFor places;
    int first_seen = 0;
    if (!marks.remark.empty()) show_paragraph(marks.remark, {Face::small, true});
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const float at = ImGui::GetCursorPosY();
      if (first_seen == 0 && at + px(2) >= ImGui::GetScrollY()) first_seen = rows[i].number;
      if (i == head) places.head = at;
      if (i == target) places.line = at;
      if (named == i) places.routine = at;
      if (const auto clicked = draw_row(rows[i], i, columns, marks)) step = clicked;
      if (marks.marked && rows[i].number == marks.marked->number) right_version(*marks.marked, columns.code);
      if (const auto fault = marks.faults.find(rows[i].number); fault != marks.faults.end() && !rows[i].text.empty())
        line_fault(fault->first, fault->second, columns.code);
    }
    if (reveals && (first != rows.end() || named)) scroll_to(places);
    gui::values().publish("listing/first-line", first_seen);
    ImGui::PopStyleVar();
  }
  ImGui::EndChild();
  return step;
}

}  // namespace ps::gui
