#include "gui/panels/studies/chart_tab.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/enumerators.h"
#include "base/kept_inputs.h"
#include "gui/panels/studies/chart_hover.h"
#include "gui/panels/studies/chart_invitation.h"
#include "gui/panels/studies/chart_strip.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "options/difference_words.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "study/chart_conclusion.h"
#include "study/chart_files.h"
#include "study/chart_style.h"
#include "study/model/model_sweep.h"

namespace ps::gui {
namespace {

constexpr StudyWords chart_words{
    .name = "chart",
    .title = "Chart",
    .measure = "Measure",
    .again = "Again",
    .help = "Renders every picture several times in the background. The time is estimated from small pictures of all "
            "points and of the reference.",
    .preparing = "preparing the first point",
    .unit = "runs",
    .kept = "Resume goes on from there"};
constexpr const char* own_sweep = "own";
constexpr double least_height_for_legend = 170;  // at scale 1; below, the room is the plot's
constexpr double least_height_for_conclusion = 130;

std::optional<std::size_t> showing(const Chart& chart, const Settings& settings) {
  for (std::size_t i = 0; i < chart.points.size(); ++i)
    if (chart.points[i].measured() && chart.points[i].what.value == settings) return i;
  return {};
}

void load_point(Session& session, const ChartPoint& point, Side side) {
  session.set_settings(side, point.what.value, fmt::format("{}: {} (chart)", letter_of(side), point.what.name));
}

/// Height of the sentence under the chart, in lines.
float conclusion_height(const std::string& conclusion, const Area& area) {
  return conclusion.empty() ? 0 : text_height(in_lines(conclusion, area.width())) + px(6);
}

void draw_conclusion(const std::string& conclusion, const Area& area) {
  draw_lines({std::round(area.min.x), std::round(area.min.y + px(2))}, in_lines(conclusion, area.width()),
             palette().text);
  controls().record("conclusion", conclusion);
}

bool any_measured(const Chart& chart) {
  return std::any_of(chart.points.begin(), chart.points.end(), [](const ChartPoint& p) { return p.measured(); });
}

}  // namespace

ChartTab::ChartTab(const PanelHost& host, const StudyFolder& results)
    : EstimatedStudy(host,
                     study_facts({.name = "chart",
                                  .group = ToolGroup::measure,
                                  .heading = "Chart",
                                  .brief = "Chart",
                                  .command = "Chart: time against error",
                                  .help = "Time against error over a sweep of options."}),
                     chart_words),
      results_(results) {}

/// The first sweep is the one whose points the most people ask for: who draws it, and how well.
void ChartTab::begin() {
  if (std::exchange(begun_, true)) return;
  if (setup.axes.empty()) set_axes(setup, parse_sweep(named_sweeps().front().key));
}

void ChartTab::follow(Session& session) {
  begin();
  sweep_.follow(session, [&](const std::string& asked) {
    set_axes(setup, parse_sweep_text(asked.empty() ? named_sweeps().front().key : asked));
    if (asked == model_sweep_key) setup.swept = Swept::model;
  });
  update_plan(plan, setup, session);
  if (kept_for_ == plan.key) return;
  kept_for_ = plan.key;
  kept_ = StudyFolder::holds_results(results_.of(plan.key));
  idle_sweeps_.clear();
  for (const NamedSweep& sweep : named_sweeps())
    idle_sweeps_.push_back(idle_sweep(sweep, plan.base, session.traits()).value_or(""));
}

void ChartTab::sweep_choice() {
  std::vector<Choice> choices;
  for (const NamedSweep& sweep : named_sweeps()) choices.push_back({sweep.key, sweep.label, ""});
  choices.push_back({model_sweep_key, "The model, full to reduced", ""});
  const std::string shown = swept_text(setup);
  const auto named = std::find_if(choices.begin(), choices.end(), [&](const Choice& c) { return c.key == shown; });
  int index = static_cast<int>(named - choices.begin());
  if (named == choices.end()) choices.push_back({own_sweep, "A custom sweep", ""});
  const auto idle = [this](std::size_t sweep) { return sweep < idle_sweeps_.size() ? idle_sweeps_[sweep] : ""; };
  if (!choice("sweep", choices, index,
              {.tooltip = "The sweep: one picture for each combination of values.",
               .width = std::min(px(220), ImGui::GetContentRegionAvail().x),
               .idle = idle}))
    return;
  const auto chosen = static_cast<std::size_t>(index);
  if (chosen < named_sweeps().size()) set_axes(setup, parse_sweep(named_sweeps()[chosen].key));
  if (choices[chosen].key != model_sweep_key) return;
  set_axes(setup, {});
  setup.swept = Swept::model;
}

void ChartTab::setup_popup(Session& session) {
  if (button("change", "Setup", Emphasis::plain, {.tooltip = "Options and values, error metric and reference."}))
    ImGui::OpenPopup("chart-setup");
  // It grows upwards from the lower edge, as options are added.
  const float width = px(400), margin = px(8);
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float left = std::max(margin, std::min(ImGui::GetItemRectMin().x, window.x - width - margin));
  ImGui::SetNextWindowPos({left, window.y - margin}, ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, window.y - 2 * margin});
  if (!ImGui::BeginPopup("chart-setup")) return;
  chart_setup_controls(setup, plan, session, host_);
  ImGui::EndPopup();
}

void ChartTab::choices(Session& session) {
  sweep_choice();
  same_line_if_room(button_width("Setup"), px(3));
  setup_popup(session);
}

void ChartTab::show_found() {
  chart = found->chart;
  chart.across = across;
  summarise(chart, metric);
  conclusion_ = chart_conclusion(chart).sentence;
}

void ChartTab::metric_choice(float width) {
  std::vector<Choice> choices;
  for (const ErrorMetricRow& row : error_metrics()) choices.push_back({row.key, row.label, ""});
  if (choice_of("metric", choices, metric, {.tooltip = "The error metric.", .width = width}) && found) show_found();
}

/// Milliseconds of this machine, work counted alike on every machine, or bytes.
void ChartTab::across_choice(float width) {
  static constexpr std::array choices{
      Choice{"time", "Time", "Milliseconds of one picture on this machine."},
      Choice{"work", "Work", "Rays, intersection tests, fragments and texel reads: the same on every machine."},
      Choice{"memory", "Memory",
             "What is made for the picture, in 10^6 bytes; with the scene's own where the model varies."}};
  if (choice_of("across", choices, across, {.tooltip = "The horizontal axis.", .width = width}) && found) show_found();
}

void ChartTab::export_menu(const Session& session) {
  if (button(
          "export", "Save", Emphasis::plain,
          {.tooltip = "Saves the chart as a table, as JSON or as a picture, or copies the command that measures it."}))
    ImGui::OpenPopup("chart-export");
  if (!ImGui::BeginPopup("chart-export")) return;
  for (const auto& [name, label, file] :
       {std::array{"csv", "Table (CSV)", "chart.csv"}, std::array{"json", "Everything (JSON)", "chart.json"},
        std::array{"svg", "Picture (SVG)", "chart.svg"}})
    if (menu_item(name, label, {}, false, chart.points.empty() ? "nothing is measured yet" : "")) ask_export(file);
  if (menu_item("command", "Copy as a command"))
    host_.copy(command_of(plan, setup, metric, session), "The command is on the clipboard.");
  ImGui::EndPopup();
}

void ChartTab::more_controls(Session& session) {
  const bool wide = ImGui::GetWindowWidth() >= px(690);
  const float width = px(wide ? 150 : 76);
  same_line_if_room(width, px(wide ? 10 : 3));
  metric_choice(width);
  same_line_if_room(px(76), px(3));
  across_choice(px(76));
  same_line_if_room(button_width("Save"), px(3));
  export_menu(session);
  const std::string shown = swept_text(setup);
  sweep_.keep(session, shown == named_sweeps().front().key ? "" : shown);
}

std::string ChartTab::measure_word() const {
  if (of_plan() && work.state() == StudyState::done) return "Again";
  return kept_ || (of_plan() && work.state() == StudyState::cancelled) ? "Resume" : "Measure";
}

void ChartTab::keep_estimate(Session& session) {
  if (!plan.error.empty() || !estimate_lacks(fmt::format("{}|{} runs", plan.key, setup.repeats))) return;
  const ChartRequest request = make_request(plan, setup, metric, session);
  if (setup.swept == Swept::model)
    begin_estimate(estimate_model, model_request(request));
  else
    begin_estimate(estimate_chart, request);
}

std::string ChartTab::expected() const {
  if (!plan.error.empty() || measure_word() == "Resume") return {};
  const bool model = setup.swept == Swept::model;
  if (const auto known = estimate.found()) return model ? at_least(known->seconds) : estimate_text(*known);
  if (model) return unknown_time();
  const std::size_t pictures = plan.points.size();
  return fmt::format("{}, {} picture{}", unknown_time(), pictures, pictures == 1 ? "" : "s");
}

std::string ChartTab::about(const Session&) const {
  if (!found) return plan.error;
  const ChartIdentity& id = chart.identity;
  const std::string swept = chart_names(chart).common;
  std::string text = fmt::format("{}{}{}, {} x {}. {}", swept, swept.empty() ? "" : ". ", id.scene, id.width, id.height,
                                 settings_in_words(chart_provenance(chart)));
  if (id.region != "all") text += fmt::format(" Only the rectangle {}.", id.region);
  if (id.values == "linear") text += " Linear values.";
  return text;
}

/// The point under the mouse: its tooltip, and into A or B by a click.
void ChartTab::load_on_click(Session& session, bool clicked) {
  if (!hovered_) return;
  const ChartPoint& point = chart.points[*hovered_];
  // Settings belong to their scene: those of one made for another may not fit.
  const bool other_model = point.what.scene != nullptr;
  const bool fits = chart.identity.scene == session.document().scene_name && !other_model;
  const bool right = ImGui::IsMouseReleased(ImGuiMouseButton_Right);
  if (fits) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (fits && clicked) load_point(session, point, right || ImGui::GetIO().KeyShift ? Side::b : Side::a);
  chart_hover(*this, point, preview,
              fits          ? "Click: into A.  Shift or right click: into B."
              : other_model ? "Needs, Model makes this scene."
                            : "Another scene is open now.");
}

void ChartTab::draw_result(Session& session) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  if (room.x < px(80) || room.y < px(60)) return;
  const Area area{{at.x, at.y + px(2)}, {at.x + room.x, at.y + room.y}};
  ImGui::SetCursorScreenPos(area.min);
  const bool clicked = ImGui::InvisibleButton("plot", {std::max(area.width(), 1.f), std::max(area.height(), 1.f)},
                                              ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  controls().record("plot", fmt::format("{:.0f}x{:.0f}", area.width(), area.height()));
  gui::values().publish("chart/plot-height", static_cast<int>(area.height()));
  const bool over = ImGui::IsItemHovered();
  if (!any_measured(chart)) return chart_invitation(*this, area, measure_word(), work.running());
  auto& list = *ImGui::GetWindowDrawList();
  const float legend = area.height() >= px(least_height_for_legend) ? chart_legend_height() : 0;
  const float conclusion = area.height() >= px(least_height_for_conclusion) ? conclusion_height(conclusion_, area) : 0;
  const float pictures = setup.swept == Swept::model ? chart_strip_height(area) : 0;
  const Area chart_area{area.min, {area.max.x, area.max.y - legend - conclusion - pictures}};
  const ChartMarks marks{showing(chart, session.settings(Side::a)), showing(chart, session.settings(Side::b)),
                         hovered_};
  const ImVec2 nowhere{-1e6f, -1e6f};
  hovered_ = draw_chart(list, chart_area, chart, labels_, marks, over ? ImGui::GetIO().MousePos : nowhere);
  if (pictures > 0)
    draw_chart_strip(*this, {{area.min.x, chart_area.max.y}, {area.max.x, chart_area.max.y + pictures}});
  const float below = chart_area.max.y + pictures;
  if (conclusion > 0) draw_conclusion(conclusion_, {{area.min.x, below}, area.max});
  if (legend > 0) draw_chart_legend(list, {{area.min.x, below + conclusion}, area.max}, chart);
  load_on_click(session, clicked);
}

void ChartTab::take(const PanelMessage& message) {
  const auto* asked = std::get_if<SweepOption>(&message);
  if (!asked) return;
  begun_ = true;
  setup.side = asked->side;
  set_axes(setup, {{asked->option, standard_values(*asked->option)}});
}

void ChartTab::measure(Session& session) {
  if (!plan.error.empty()) return;
  const auto folder = results_.of(plan.key);
  if (measure_word() == "Again") StudyFolder::forget(folder);
  ChartRequest request = make_request(plan, setup, metric, session);
  request.folder = folder;
  const auto shown = std::exchange(measured_, plan.key) == plan.key ? found : nullptr;
  start([request = std::move(request), swept = setup.swept,
         from = settings_for(session.document().base)](StudyControl& control, const Report& report) mutable {
    if (swept == Swept::model) request.points = model_sweep(request, from, control);
    run_chart_study(request, control, report);
    return nullptr;
  });
  found = shown;  // stays until the first new point
  kept_for_.clear();
  if (shown) return;
  chart = {};
  conclusion_.clear();
}

void ChartTab::ask_export(const std::string& suggestion) {
  host_.ask_file({.title = "Save the chart",
                  .extensions = {".csv", ".json", ".svg"},
                  .hint = "chart.svg",
                  .suggestion = suggestion,
                  .answer = [this](const FileAnswer& file) {
                    session_.say_saved([&] {
                      require_no_input(file.path, files_of(session_.document().base));
                      write(file.path);
                      return fmt::format("Saved {}.", file.path.string());
                    });
                  }});
}

void ChartTab::write(const std::filesystem::path& path) const {
  const std::string extension = path.extension().string();
  if (extension == ".csv")
    write_file_atomically(path, chart_csv(chart));
  else if (extension == ".json")
    write_file_atomically(path, chart_json(chart));
  else if (extension == ".svg")
    write_file_atomically(path, chart_svg(chart));
  else
    throw InputError(
        fmt::format("{}: found the extension '{}', expected .csv, .json or .svg", path.string(), extension));
}

namespace {

/// "3/error": what was measured of the point with this number.
std::optional<std::string> point_value(const Chart& chart, std::string_view name) {
  for (const ChartPoint& point : chart.points) {
    const std::string number = fmt::format("{}/", point.number);
    if (!point.measured() || !name.starts_with(number)) continue;
    const std::string_view what = name.substr(number.size());
    if (what == "settings") return point.what.settings;
    if (what == "error") return script_text(point.error);
    if (what == "time-ms") return script_text(point.time_ms.median);
    if (what == "upload-ms" && point.upload_ms) return script_text(point.upload_ms->median);
    if (what == "memory-mb") return script_text(point.memory_mb);
    if (what == "work") return ps::work_text(point.work);
    if (what == "on-front") return script_text(point.on_front);
    if (what == "tie") return script_text(point.tie);
    if (what == "standing") return std::string(enumerator_key(point.standing));
    if (what == "left-out") return fmt::format("{}", fmt::join(brief_texts(point.left_out), "; "));
    if (what == "runs") return script_text(static_cast<int>(point.samples_ms.size()));
  }
  return {};
}

}  // namespace

void ChartTab::offer_found(Values& out) const {
  out.offer_below("chart/of/", [this](std::string_view name) { return point_value(chart, name); });
  out.offer("chart/planned", [this] { return static_cast<int>(plan.points.size()); });
  out.offer("chart/measured", [this] {
    return static_cast<int>(std::count_if(chart.points.begin(), chart.points.end(),
                                          [](const ChartPoint& point) { return point.measured(); }));
  });
  out.offer("chart/runs-done", [this] { return work.status().done; });
  out.offer("chart/truth", [this] { return chart.identity.reference; });
  out.offer("chart/machinery", [this] { return chart.identity.machinery; });
  out.offer("chart/conclusion", [this] { return conclusion_; });
  out.offer("chart/hovered", [this] { return hovered_ ? chart.points[*hovered_].what.label : std::string(); });
}

}  // namespace ps::gui
