#include "gui/panels/studies/timings_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "gui/base/record.h"
#include "gui/panels/pictures/picture_text.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "raster/clear/coverage/efficiency.h"

namespace ps::gui {
namespace {

using Results = std::array<std::shared_ptr<const RenderResult>, 2>;

constexpr double label_width = 260, timing_width = 74;
constexpr double table_width = label_width + 3 * timing_width + 40;

/// In a narrow window the labels give way, not the numbers.
ImVec2 table_size() { return {std::min(px(table_width), ImGui::GetContentRegionAvail().x), 0}; }

void timing_columns() {
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
  for (const char* name : {"A", "B", "B / A"})
    ImGui::TableSetupColumn(name, ImGuiTableColumnFlags_WidthFixed, px(timing_width));
}

enum class Ratio { none, shown };

void heading(const char* what, Ratio ratio) {
  ImGui::TableNextRow();
  int column = 0;
  for (const char* text : {what, "A", "B", ratio == Ratio::shown ? "B / A" : ""}) {
    ImGui::TableNextColumn();
    const FontScope font(Face::bold);
    ImGui::PushStyleColor(ImGuiCol_Text, column == 1 || column == 2 ? palette().text : palette().text_quiet);
    if (column > 0)
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() +
                           std::max(0.f, ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text).x));
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
    if (column == 1 || column == 2) {
      const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
      side_bar(*ImGui::GetWindowDrawList(), {low.x - px(8), low.y + px(2)}, {low.x - px(4), high.y - px(2)},
               column == 1 ? Side::a : Side::b);
    }
    ++column;
  }
}

using Pair = std::array<std::optional<double>, 2>;
using NumberText = std::function<std::string(double)>;

/// A label and two numbers; a missing number stays blank. The last column is left to the caller.
void row(std::string_view label, const Pair& values, const NumberText& text) {
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
}

std::optional<double> ratio_of(const Pair& values) {
  if (!values[0] || !values[1] || *values[0] <= 0) return {};
  return *values[1] / *values[0];
}

std::optional<double> stage_time(const std::shared_ptr<const RenderResult>& result, const std::string& stage) {
  if (!result) return {};
  for (const auto& time : result->frame.times)
    if (time.stage == stage) return time.milliseconds;
  return {};
}

/// Times of the runs that made the pictures. They are not to be compared with one another, so there is no ratio.
void single_times(const Results& results) {
  if (!ImGui::BeginTable("times", 4, ImGuiTableFlags_SizingFixedFit, table_size())) return;
  timing_columns();
  heading("Time of one run, ms", Ratio::none);
  std::vector<std::string> stages;
  for (const auto& result : results)
    if (result)
      for (const auto& time : result->frame.times)
        if (std::find(stages.begin(), stages.end(), time.stage) == stages.end()) stages.push_back(time.stage);
  const auto roughly = [](double value) { return value <= 0 ? "0" : fmt::format("~{}", two_digits(value)); };
  ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
  Pair all;
  for (std::size_t i = 0; i < 2; ++i)
    if (results[i]) all[i] = results[i]->milliseconds;
  row("whole render", all, roughly);
  for (const auto& stage : stages) row(stage, {stage_time(results[0], stage), stage_time(results[1], stage)}, roughly);
  ImGui::PopStyleColor();
  ImGui::EndTable();
}

void median_times(const PairTiming& timing) {
  if (!ImGui::BeginTable("times", 4, ImGuiTableFlags_SizingFixedFit, table_size())) return;
  timing_columns();
  heading("Median time, ms", Ratio::shown);
  row("whole render", {timing.time_ms[0].median, timing.time_ms[1].median}, three_digits);
  number_text(two_digits(timing.ratio.median), 0, full_number(timing.ratio.median));
  row("lower quartile", {timing.time_ms[0].q1, timing.time_ms[1].q1}, three_digits);
  row("upper quartile", {timing.time_ms[0].q3, timing.time_ms[1].q3}, three_digits);
  for (const PairStage& stage : timing.stages) row(stage.stage, stage.median_ms, three_digits);
  ImGui::EndTable();
}

void sentence(const std::string& name, const std::string& text) {
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + table_size().x);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  controls().record(name, text);
}

/// Whether the timing is of the pictures that are shown.
bool of_these(const FoundTiming& found, const Results& results) {
  for (std::size_t side = 0; side < 2; ++side)
    if (!results[side] || results[side]->request.shown != found.requests[side].shown ||
        !same_render(results[side]->request, found.requests[side]))
      return false;
  return true;
}

void start(TimingsState& state, const Results& results) {
  FoundTiming found;
  PairTimingRequest request;
  for (std::size_t side = 0; side < 2; ++side) {
    found.requests[side] = results[side]->request;
    request.settings[side] = results[side]->request.settings;
    request.channels[side] = results[side]->channels;
  }
  request.scene = results[0]->request.scene;
  request.view = results[0]->request.view;
  request.region = results[0]->request.region;
  request.priority = WorkerPriority::background;
  state.study.start([request = std::move(request), found = std::move(found)](
                        StudyControl& control, const BackgroundStudy<FoundTiming>::Publish& publish) mutable {
    StudyStatus last;
    found.timing = time_pair(request, {}, control, [&](const StudyStatus& status) {
      last = status;
      publish(nullptr, status);
    });
    last.done = last.total;
    publish(std::make_shared<const FoundTiming>(std::move(found)), last);
  });
}

/// Why both cannot be timed now; empty if they can.
std::string reason_against(Session& session, const Results& results) {
  if (session.picture_b()) return "B is a picture file.";
  for (const Side side : both_sides)
    if (!results[index_of(side)] || session.renderer(side).status().state != RenderState::done)
      return "The pictures are not finished.";
  return "";
}

void run_line(Session& session, TimingsState& state, const Results& results) {
  if (state.study.running()) {
    if (button("cancel", "Cancel")) state.study.cancel();
    ImGui::SameLine(0, px(8));
    ImGui::AlignTextToFramePadding();
    const StudyStatus status = state.study.status();
    value_text("state", status.total > 0 ? status_text(status, "runs") : "warming up");
    return;
  }
  if (button("time", "Time A and B", Emphasis::primary,
             {.tooltip = "Renders A and B in turn, warm, and shows the median and the quartiles.",
              .disabled = reason_against(session, results)}))
    start(state, results);
  if (state.study.state() == StudyState::failed) sentence("state", "Failed: " + state.study.message());
}

/// The code path of each picture, and why it was not a faster one.
void machinery(const Results& results) {
  ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
  for (const Side side : both_sides) {
    const auto& result = results[index_of(side)];
    if (!result) continue;
    const FastPath& path = result->frame.path;
    std::string text = fmt::format("{}: {}", letter_of(side), machinery_label(path.machinery));
    if (!path.reason.empty()) text += fmt::format(" ({})", path.reason);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + table_size().x);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    controls().record(fmt::format("machinery/{}", letter_of(side)), text);
  }
  ImGui::PopStyleColor();
}

void counters(const Results& results) {
  if (!ImGui::BeginTable("counters", 4, ImGuiTableFlags_SizingFixedFit, table_size())) return;
  timing_columns();
  heading("Work", Ratio::shown);
  for (std::size_t i = 0; i < counter_count; ++i) {
    const auto counter = static_cast<Counter>(i);
    Pair values;
    bool any = false;
    for (std::size_t side = 0; side < 2; ++side) {
      if (!results[side]) continue;
      const auto count = results[side]->frame.counters.get(counter);
      if (!count) continue;  // this renderer cannot give it
      values[side] = static_cast<double>(*count);
      any = any || *count > 0;
    }
    if (!any) continue;
    row(counter_label(counter), values, [](double value) { return count_text(static_cast<std::uint64_t>(value)); });
    if (const auto ratio = ratio_of(values)) number_text(*ratio);
  }
  Pair efficiency;
  for (std::size_t side = 0; side < 2; ++side)
    if (results[side]) efficiency[side] = raster::sample_test_efficiency(results[side]->frame.counters);
  if (efficiency[0] || efficiency[1]) {
    row("fragments per coverage test", efficiency, [](double value) { return short_number(value); });
    if (const auto ratio = ratio_of(efficiency)) number_text(*ratio);
  }
  ImGui::EndTable();
}

}  // namespace

void timings_panel(Session& session, TimingsState& state) {
  const NameScope scope("timings");
  const Results results{session.renderer(Side::a).result(), session.renderer(Side::b).result()};
  const bool timed = state.found && of_these(*state.found, results);
  ImGui::BeginChild("timings");
  run_line(session, state, results);
  const float column = px(table_width + 20);
  const bool beside = ImGui::GetContentRegionAvail().x >= 2 * column;
  ImGui::BeginGroup();
  if (timed) {
    sentence("ratio", ratio_sentence(state.found->timing));
    median_times(state.found->timing);
  } else {
    single_times(results);
  }
  machinery(results);
  ImGui::EndGroup();
  if (beside) ImGui::SameLine(column);
  ImGui::BeginGroup();
  counters(results);
  ImGui::EndGroup();
  ImGui::EndChild();
}

}  // namespace ps::gui
