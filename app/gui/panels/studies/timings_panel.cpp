#include "gui/panels/studies/timings_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "gui/base/record.h"
#include "gui/panels/pictures/picture_text.h"
#include "gui/widgets/draw.h"
#include "raster/clear/coverage/efficiency.h"

namespace ps::gui {
namespace {

using Results = std::array<std::shared_ptr<const RenderResult>, 2>;

constexpr double label_width = 260, number_width = 74;
constexpr double table_width = label_width + 3 * number_width + 40;

/// In a narrow window the labels give way, not the numbers.
ImVec2 table_size() { return {std::min(px(table_width), ImGui::GetContentRegionAvail().x), 0}; }

void columns() {
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
  for (const char* name : {"A", "B", "B / A"})
    ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthFixed, px(number_width));
}

void heading(const char* what) {
  ImGui::TableNextRow();
  int column = 0;
  for (const char* text : {what, "A", "B", "B / A"}) {
    ImGui::TableNextColumn();
    const FontScope font(Face::bold);
    const ImVec4 colour = column == 1 ? palette().a_text : column == 2 ? palette().b_text : palette().text_quiet;
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    if (column > 0)
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() +
                           std::max(0.f, ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text).x));
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
    ++column;
  }
}

/// A label and two numbers; a missing number stays blank.
void row(std::string_view label, const std::array<std::optional<double>, 2>& values,
         const std::function<std::string(double)>& text) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  const std::string lines = in_lines(label, room);
  draw_lines(at, lines, palette().text);
  ImGui::Dummy({room, text_height(lines)});
  for (const auto& value : values) {
    ImGui::TableNextColumn();
    if (value) number_text(text(*value), 0, full_number(*value));
  }
  ImGui::TableNextColumn();
  if (values[0] && values[1] && *values[0] > 0) number_text(*values[1] / *values[0]);
}

std::optional<double> stage_time(const std::shared_ptr<const RenderResult>& result, const std::string& stage) {
  if (!result) return {};
  for (const auto& time : result->frame.times)
    if (time.stage == stage) return time.milliseconds;
  return {};
}

void times(const Results& results) {
  if (!ImGui::BeginTable("times", 4, ImGuiTableFlags_SizingFixedFit, table_size())) return;
  columns();
  heading("Time, ms");
  std::vector<std::string> stages;
  for (const auto& result : results)
    if (result)
      for (const auto& time : result->frame.times)
        if (std::find(stages.begin(), stages.end(), time.stage) == stages.end()) stages.push_back(time.stage);
  const auto in_ms = [](double value) { return short_number(value); };
  for (const auto& stage : stages) row(stage, {stage_time(results[0], stage), stage_time(results[1], stage)}, in_ms);
  std::array<std::optional<double>, 2> all;
  for (std::size_t i = 0; i < 2; ++i)
    if (results[i]) all[i] = results[i]->milliseconds;
  row("whole render", all, in_ms);
  ImGui::EndTable();
}

/// Which code drew each picture, and why it was nothing faster.
void machinery(const Results& results) {
  ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
  for (const Side side : both_sides) {
    const auto& result = results[index_of(side)];
    if (!result) continue;
    const FastPath& path = result->frame.path;
    std::string text = fmt::format("{}: {}", letter_of(side), machinery_label(path.machinery));
    if (!path.reason.empty()) text += fmt::format(" ({})", path.reason);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + px(table_width));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    controls().record(fmt::format("machinery/{}", letter_of(side)), text);
  }
  ImGui::PopStyleColor();
}

void counters(const Results& results) {
  if (!ImGui::BeginTable("counters", 4, ImGuiTableFlags_SizingFixedFit, table_size())) return;
  columns();
  heading("Work");
  for (std::size_t i = 0; i < counter_count; ++i) {
    const auto counter = static_cast<Counter>(i);
    std::array<std::optional<double>, 2> values;
    bool any = false;
    for (std::size_t side = 0; side < 2; ++side) {
      if (!results[side]) continue;
      const auto count = results[side]->frame.counters.get(counter);
      if (!count) continue;  // this renderer cannot give it
      values[side] = static_cast<double>(*count);
      any = any || *count > 0;
    }
    if (any)
      row(counter_label(counter), values, [](double value) { return count_text(static_cast<std::uint64_t>(value)); });
  }
  std::array<std::optional<double>, 2> efficiency;
  for (std::size_t side = 0; side < 2; ++side)
    if (results[side]) efficiency[side] = raster::sample_test_efficiency(results[side]->frame.counters);
  if (efficiency[0] || efficiency[1])
    row("fragments per coverage test", efficiency, [](double value) { return short_number(value); });
  ImGui::EndTable();
}

}  // namespace

void timings_panel(Session& session) {
  const NameScope scope("timings");
  const Results results{session.renderer(Side::a).result(), session.renderer(Side::b).result()};
  ImGui::BeginChild("timings");
  const float column = px(table_width + 20);
  const bool beside = ImGui::GetContentRegionAvail().x >= 2 * column;
  ImGui::BeginGroup();
  times(results);
  machinery(results);
  ImGui::EndGroup();
  if (beside) ImGui::SameLine(column);
  ImGui::BeginGroup();
  counters(results);
  ImGui::EndGroup();
  ImGui::EndChild();
}

}  // namespace ps::gui
