#include "gui/panels/story/ledger_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gui/widgets/draw.h"
#include "inspect/shown_term.h"

namespace ps::gui {
namespace {

constexpr double number_width = 72, swatch_size = 13, indent_step = 12;
constexpr double least_gap = 6;            // between two numbers
constexpr std::size_t most_brief = 6;      // letters of a number where there is little room
constexpr double room_for_one_line = 250;  // beside the numbers, for the words
constexpr double narrow_ledger = 256;      // smaller letters below this width

ImU32 swatch_colour(const Vec3d& value) {
  const auto level = [](double v) { return std::lround(std::clamp(v, 0.0, 1.0) * 255); };
  return IM_COL32(level(value.x), level(value.y), level(value.z), 255);
}

/// The lines at the end that show what the display does with the sum; they add nothing.
bool tells_only(const PixelStory& story, const LedgerLine& line) {
  return line.event >= 0 && line.event + 1 == static_cast<int>(story.events.size()) && line.level == 0 &&
         line.value == Vec3d(0, 0, 0);
}

/// Where the parts of a line go.
struct LedgerColumns {
  float left = 0, right = 0;  // window pixels
  bool one_line = true;       // words and numbers side by side; else the numbers are below the words
  float number = 0;           // width of one number with the space before it
  Face digits = Face::mono;   // that fit there
  bool brief = false;         // or not even the smallest do: fewer digits

  float number_right(int channel) const {
    return right - px(swatch_size + 8) - number * static_cast<float>(2 - channel);
  }
};

void number_at(Face face, float right, float top, std::string_view text, const ImVec4& colour) {
  const FontScope font(face);
  draw_lines({right - text_width(text), top}, text, colour);
}

std::string number_in(const LedgerColumns& columns, double value) {
  std::string text = short_number(value);
  if (!columns.brief || text.size() <= most_brief) return text;
  // As wide as most others, and read without thinking; only what would become 0 is written with a power.
  const std::string plain = fmt::format("{:.4f}", value);
  return std::abs(value) >= 0.0005 && plain.size() <= most_brief ? plain : fmt::format("{:.1e}", value);
}

/// The largest letters in which no number touches the one before it.
void choose_digits(const PixelStory& story, LedgerColumns& columns) {
  const auto widest = [&](Face face) {
    float width = 0;
    for (const LedgerLine& line : story.ledger)
      for (int channel = 0; channel < 3; ++channel)
        width = std::max(width, text_width(number_in(columns, line.value[channel]), face));
    return width;
  };
  const float room = columns.number - px(least_gap);
  for (const Face face : {Face::mono, Face::small}) {
    columns.digits = face;
    if (widest(face) <= room) return;
  }
  columns.brief = true;
}

void headings(const LedgerColumns& columns) {
  const float top = ImGui::GetCursorScreenPos().y;
  int channel = 0;
  for (const char* name : {"red", "green", "blue"})
    number_at(Face::small, columns.number_right(channel++), top, name, palette().text_quiet);
  ImGui::Dummy({1, theme().font(Face::small)->FontSize});
}

/// The old number in one channel of a line; empty where it reads the same.
std::string number_of_then(const LedgerChange* change, int channel) {
  if (!change || !change->after || !change->changed()) return {};
  if (!change->before) return channel == 2 ? "new" : "";
  const std::string old = short_number((*change->before)[channel]);
  return old == short_number((*change->after)[channel]) ? std::string() : old + " →";
}

bool line_row(const std::string& name, const LedgerLine& line, bool selected, const LedgerColumns& columns,
              const LedgerChange* change) {
  auto& list = *ImGui::GetWindowDrawList();
  const Face face = columns.right - columns.left < px(narrow_ledger) ? Face::small : Face::body;
  ImFont* words = theme().font(face);
  ImFont* digits = theme().font(columns.digits);
  const float pitch = std::max(words->FontSize, digits->FontSize) + px(3);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float left = at.x + px(indent_step) * static_cast<float>(line.level) + px(4);
  const float words_width = (columns.one_line ? columns.number_right(0) - columns.number : columns.right) - left;
  const auto [lines, words_height] = [&] {
    const FontScope font(face);
    std::string broken = in_lines(line.term, words_width);
    const float high = text_height(broken) + px(3);
    return std::pair{std::move(broken), high};
  }();
  ImFont* small = theme().font(Face::small);
  const std::array then{number_of_then(change, 0), number_of_then(change, 1), number_of_then(change, 2)};
  const bool changed = !then[0].empty() || !then[1].empty() || !then[2].empty();
  const float before = changed ? small->FontSize : 0;  // room for the numbers of then
  const float height = columns.one_line ? std::max(pitch + before, words_height) : words_height + before + pitch;
  const bool clicked = ImGui::Selectable(("##" + name).c_str(), selected, 0, {0, height});
  controls().record(name, line.term);
  if (changed) controls().record(name + "/then", fmt::format("{} {} {}", then[0], then[1], then[2]));
  tooltip(fmt::format("{}\n{}  {}  {}", line.term, full_number(line.value.x), full_number(line.value.y),
                      full_number(line.value.z)));
  {
    const FontScope font(face);
    draw_lines({left, at.y}, lines, palette().text);
  }
  const float top = (columns.one_line ? at.y : at.y + words_height) + before;
  for (int channel = 0; channel < 3; ++channel) {
    number_at(Face::small, columns.number_right(channel), top - before, then.at(static_cast<std::size_t>(channel)),
              palette().text_quiet);
    number_at(columns.digits, columns.number_right(channel), top, number_in(columns, line.value[channel]),
              palette().text);
  }
  const float size = px(swatch_size);
  const ImVec2 corner{columns.right - size, top + (pitch - size) / 2 - px(1)};
  draw_swatch(list, corner, {size, size}, swatch_colour(line.value));
  return clicked;
}

/// Terms that the sum had then and has no more.
void gone_lines(const std::string& name, const StoryChanges& changes) {
  int index = 0;
  for (const LedgerChange& line : changes.ledger)
    if (line.before && !line.after && *line.before != Vec3d(0, 0, 0))
      value_paragraph(fmt::format("{}/ledger-gone/{}", name, index++),
                      fmt::format("gone: {}, was {} {} {}", line.term, short_number(line.before->x),
                                  short_number(line.before->y), short_number(line.before->z)),
                      {.quiet = true});
}

}  // namespace

int ledger_view(const std::string& name, const PixelStory& story, int selected_event, const PinnedStory* pinned) {
  int clicked = -1;
  LedgerColumns columns;
  columns.left = ImGui::GetCursorScreenPos().x;
  columns.right = columns.left + ImGui::GetContentRegionAvail().x;
  columns.one_line = columns.right - columns.left - px(3 * number_width + swatch_size) >= px(room_for_one_line);
  columns.number = std::min(px(number_width), (columns.right - columns.left - px(swatch_size + 8)) / 3);
  choose_digits(story, columns);
  headings(columns);
  const int shown = shown_term(story, selected_event);
  std::string selected_term = "none";
  for (std::size_t index = 0; index < story.ledger.size(); ++index) {
    const LedgerLine& line = story.ledger[index];
    const LedgerChange* change = pinned ? &pinned->term_of(index) : nullptr;
    const std::string row = fmt::format("{}/ledger/{}", name, index);
    if (line.event >= 0 && line.event == shown && selected_term == "none") selected_term = line.term;
    if (tells_only(story, line)) {
      value_paragraph(row, line.term, {.quiet = true});
    } else if (line_row(row, line, line.event >= 0 && line.event == shown, columns, change)) {
      clicked = line.event;
    }
  }
  controls().record(name + "/selected-term", selected_term);
  if (pinned) gone_lines(name, pinned->changes);
  return clicked;
}

}  // namespace ps::gui
