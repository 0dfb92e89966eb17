#include "gui/panels/studies/timings_tab.h"

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

constexpr StudyWords timings_words{.name = "timings",
                                   .title = "Timings",
                                   .measure = "Time A and B",
                                   .again = "Time A and B",
                                   .help = "Renders A and B in turn, warm, and shows the median and the quartiles.",
                                   .preparing = "warming up",
                                   .unit = "runs"};

using Results = std::array<std::shared_ptr<const RenderResult>, 2>;

constexpr double label_width = 260, timing_width = 92;
constexpr double table_width = label_width + 3 * timing_width + 40;

/// In a narrow window the labels give way, not the numbers.
float width_of_table() { return std::min(px(table_width), ImGui::GetContentRegionAvail().x); }

/// A table for a number of A, one of B, and their ratio, with its headings.
bool begin_pairs(const char* id, const char* what, const char* ratio) {
  if (!begin_numbers(id, 3, {.numbers = px(timing_width), .all = width_of_table()})) return false;
  const TextScope quiet({Face::bold, true});
  numbers_row(what);
  for (const Side side : both_sides) {
    const std::string letter(1, letter_of(side));
    number_cell(letter, letter);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    side_bar(*ImGui::GetWindowDrawList(), {low.x - px(8), low.y + px(2)}, {low.x - px(4), high.y - px(2)}, side);
  }
  number_cell(ratio, ratio);
  return true;
}

using Pair = std::array<std::optional<double>, 2>;
using NumberText = std::function<std::string(double)>;

/// A label and two numbers; a missing number stays blank. The last column is left to the caller.
void row(std::string_view label, const Pair& values, const NumberText& text) {
  numbers_row(label);
  for (const auto& value : values) number_cell(value ? text(*value) : "", value ? full_number(*value) : "");
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
  if (!begin_pairs("times", "Time of one run, ms", "")) return;
  std::vector<std::string> stages;
  for (const auto& result : results)
    if (result)
      for (const auto& time : result->frame.times)
        if (std::find(stages.begin(), stages.end(), time.stage) == stages.end()) stages.push_back(time.stage);
  const auto roughly = [](double value) { return value <= 0 ? "0" : fmt::format("~{}", two_digits(value)); };
  const TextScope quiet({.quiet = true});
  Pair all;
  for (std::size_t i = 0; i < 2; ++i)
    if (results[i]) all[i] = results[i]->milliseconds;
  row("whole render", all, roughly);
  for (const auto& stage : stages) row(stage, {stage_time(results[0], stage), stage_time(results[1], stage)}, roughly);
  ImGui::EndTable();
}

void median_times(const PairTiming& timing) {
  if (!begin_pairs("times", "Median time, ms", "B / A")) return;
  row("whole render", {timing.time_ms[0].median, timing.time_ms[1].median}, three_digits);
  number_cell(two_digits(timing.ratio.median), full_number(timing.ratio.median));
  row("lower quartile", {timing.time_ms[0].q1, timing.time_ms[1].q1}, three_digits);
  row("upper quartile", {timing.time_ms[0].q3, timing.time_ms[1].q3}, three_digits);
  for (const PairStage& stage : timing.stages) row(stage.stage, stage.median_ms, three_digits);
  ImGui::EndTable();
}

void sentence(const std::string& name, const std::string& text) {
  show_text(in_lines(text, width_of_table()));
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

Results results_of(Session& session) {
  return {session.renderer(Side::a).result(), session.picture_b() ? nullptr : session.renderer(Side::b).result()};
}

/// The code path of each picture, and why it was not a faster one.
void machinery(const Results& results) {
  const TextScope quiet({.quiet = true});
  for (const Side side : both_sides) {
    const auto& result = results[index_of(side)];
    if (!result) continue;
    const FastPath& path = result->frame.path;
    std::string text = fmt::format("{}: {}", letter_of(side), machinery_label(path.machinery));
    if (!path.reason.empty()) text += fmt::format(" ({})", path.reason);
    sentence(fmt::format("machinery/{}", letter_of(side)), text);
  }
}

void counters(const Results& results) {
  if (!begin_pairs("counters", "Work", "B / A")) return;
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
    if (const auto ratio = ratio_of(values)) number_cell(short_number(*ratio), full_number(*ratio));
  }
  Pair efficiency;
  for (std::size_t side = 0; side < 2; ++side)
    if (results[side]) efficiency[side] = raster::sample_test_efficiency(results[side]->frame.counters);
  if (efficiency[0] || efficiency[1]) {
    row("fragments per coverage test", efficiency, [](double value) { return short_number(value); });
    if (const auto ratio = ratio_of(efficiency)) number_cell(short_number(*ratio), full_number(*ratio));
  }
  ImGui::EndTable();
}

}  // namespace

TimingsTab::TimingsTab(const PanelHost& host)
    : Study(host,
            study_facts({.name = "timings",
                         .group = ToolGroup::measure,
                         .heading = "Timings",
                         .brief = "Times",
                         .command = "Timings: times and counts",
                         .help = "Times of the stages and counts of the work, A beside B."}),
            timings_words) {}

void TimingsTab::measure(Session& session) {
  const Results results = results_of(session);
  FoundTiming timed;
  PairTimingRequest request;
  for (std::size_t side = 0; side < 2; ++side) {
    timed.requests[side] = results[side]->request;
    request.settings[side] = results[side]->request.settings;
    request.channels[side] = results[side]->channels;
  }
  request.scene = results[0]->request.scene;
  request.view = results[0]->request.view;
  request.region = results[0]->request.region;
  request.priority = WorkerPriority::background;
  start([request = std::move(request), timed = std::move(timed)](StudyControl& control, const Report& report) {
    auto result = std::make_shared<FoundTiming>(timed);
    result->timing = time_pair(request, {}, control, [&](const StudyStatus& status) { report(status, nullptr); });
    return result;
  });
}

std::string TimingsTab::reason_against(Session& session) const {
  if (std::string reason = why_not_b(session); !reason.empty()) return reason;
  const Results results = results_of(session);
  for (const Side side : both_sides)
    if (!results[index_of(side)] || session.renderer(side).status().state != RenderState::done)
      return "The pictures are not finished.";
  return "";
}

void TimingsTab::take_up(Session& session) {
  Study::take_up(session);
  if (!work.running() || !session.has_scene()) return;
  for (const Side side : both_sides)
    if (session.renderer(side).status().state != RenderState::done) return work.cancel();
}

void TimingsTab::took(Session& session) {
  if (!found) return;
  for (std::size_t side = 0; side < 2; ++side)
    session.work().timed().add({found->requests[side], found->timing.time_ms[side], found->timing.rounds()});
}

void TimingsTab::draw_result(Session& session) {
  const Results results = results_of(session);
  const float column = px(table_width + 20);
  const bool beside = ImGui::GetContentRegionAvail().x >= 2 * column;
  ImGui::BeginGroup();
  if (found && of_these(*found, results)) {
    sentence("ratio", ratio_sentence(found->timing));
    median_times(found->timing);
  } else {
    single_times(results);
  }
  machinery(results);
  ImGui::EndGroup();
  if (beside) ImGui::SameLine(column);
  ImGui::BeginGroup();
  counters(results);
  ImGui::EndGroup();
}

void TimingsTab::offer_found(Values& out) const {
  out.offer("timings/rounds", [this] { return found ? found->timing.rounds() : 0; });
}

std::string ratio_sentence(const PairTiming& timing) {
  const Quartiles& ratio = timing.ratio;
  if (!timing.shows_an_order())
    return fmt::format("{}: B / A is {:.2g} ({:.2g} to {:.2g}; {} rounds).",
                       timing.equal_settings ? "The options of A and B are equal, and times differ by noise alone"
                                             : "The times of A and B are equal within noise",
                       ratio.median, ratio.q1, ratio.q3, timing.rounds());
  const bool b_longer = ratio.median > 1;
  const double factor = b_longer ? ratio.median : 1 / ratio.median, low = b_longer ? ratio.q1 : 1 / ratio.q3,
               high = b_longer ? ratio.q3 : 1 / ratio.q1;
  return fmt::format("{} takes {:.2g} times as long as {} ({:.2g} to {:.2g}; {} rounds).", b_longer ? 'B' : 'A', factor,
                     b_longer ? 'A' : 'B', low, high, timing.rounds());
}

}  // namespace ps::gui
