#include "gui/app/ledger_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "gui/widgets/draw.h"

namespace ps::gui {
namespace {

constexpr double number_width = 72, swatch_size = 13, indent_step = 12;
constexpr double room_for_one_line = 250;  // beside the numbers, for the words
constexpr double narrow = 256;             // smaller letters below this width

ImU32 swatch_colour(const Vec3d& value) {
  const auto level = [](double v) { return static_cast<int>(std::clamp(v, 0.0, 1.0) * 255 + 0.5); };
  return IM_COL32(level(value.x), level(value.y), level(value.z), 255);
}

/// The lines at the end that tell what the display does with the sum; they add nothing.
bool tells_only(const PixelStory& story, const LedgerLine& line) {
  return line.event >= 0 && line.event + 1 == static_cast<int>(story.events.size()) && line.level == 0 &&
         line.value == Vec3d(0, 0, 0);
}

/// Where the parts of a line go.
struct Columns {
  float left = 0, right = 0;  // window pixels
  bool one_line = true;       // words and numbers side by side; else the numbers stand below the words
  float number = 0;           // width of one number with the space before it

  float number_right(int channel) const {
    return right - px(swatch_size + 8) - number * static_cast<float>(2 - channel);
  }
};

void number_at(ImDrawList& list, ImFont* font, float right, float top, const std::string& text, ImU32 colour) {
  const float width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x;
  list.AddText(font, font->FontSize, {right - width, top}, colour, text.c_str());
}

void headings(const Columns& columns) {
  auto& list = *ImGui::GetWindowDrawList();
  ImFont* font = theme().font(Face::small);
  const float top = ImGui::GetCursorScreenPos().y;
  int channel = 0;
  for (const char* name : {"red", "green", "blue"})
    number_at(list, font, columns.number_right(channel++), top, name, colour_u32(palette().text_quiet));
  ImGui::Dummy({1, font->FontSize});
}

bool line_row(const std::string& name, const LedgerLine& line, bool selected, const Columns& columns) {
  auto& list = *ImGui::GetWindowDrawList();
  const Face face = columns.right - columns.left < px(narrow) ? Face::small : Face::body;
  ImFont* words = theme().font(face);
  ImFont* digits = theme().font(columns.number < px(number_width) ? Face::small : Face::mono);
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
  const float height = columns.one_line ? std::max(pitch, words_height) : words_height + pitch;
  const bool clicked = ImGui::Selectable(("##" + name).c_str(), selected, 0, {0, height});
  controls().record(name, line.term);
  tooltip(fmt::format("{}\n{}  {}  {}", line.term, full_number(line.value.x), full_number(line.value.y),
                      full_number(line.value.z)));
  const ImU32 ink = colour_u32(palette().text);
  {
    const FontScope font(face);
    draw_lines({left, at.y}, lines, palette().text);
  }
  const float top = columns.one_line ? at.y : at.y + words_height;
  for (int channel = 0; channel < 3; ++channel)
    number_at(list, digits, columns.number_right(channel), top, short_number(line.value[channel]), ink);
  const float size = px(swatch_size);
  const ImVec2 corner{columns.right - size, top + (pitch - size) / 2 - px(1)};
  list.AddRectFilled(corner, {corner.x + size, corner.y + size}, swatch_colour(line.value));
  list.AddRect(corner, {corner.x + size, corner.y + size}, colour_u32(palette().line_strong));
  return clicked;
}

}  // namespace

int ledger_view(const std::string& name, const PixelStory& story, int selected_event) {
  int clicked = -1;
  Columns columns;
  columns.left = ImGui::GetCursorScreenPos().x;
  columns.right = columns.left + ImGui::GetContentRegionAvail().x;
  columns.one_line = columns.right - columns.left - px(3 * number_width + swatch_size) >= px(room_for_one_line);
  columns.number = std::min(px(number_width), (columns.right - columns.left - px(swatch_size + 8)) / 3);
  headings(columns);
  int index = 0;
  for (const auto& line : story.ledger) {
    const std::string row = fmt::format("{}/ledger/{}", name, index++);
    if (tells_only(story, line)) {
      ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
      ImGui::PushTextWrapPos(0);
      value_text(row, line.term);
      ImGui::PopTextWrapPos();
      ImGui::PopStyleColor();
    } else if (line_row(row, line, line.event >= 0 && line.event == selected_event, columns)) {
      clicked = line.event;
    }
  }
  return clicked;
}

}  // namespace ps::gui
