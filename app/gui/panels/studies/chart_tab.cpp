#include "gui/panels/studies/chart_tab.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/atomic_file.h"
#include "base/check.h"
#include "gui/base/values.h"
#include "gui/panels/studies/chart_hover.h"
#include "gui/panels/studies/chart_invitation.h"
#include "gui/panels/studies/pause_and_stop.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "study/chart_conclusion.h"
#include "study/chart_files.h"
#include "study/chart_style.h"
#include "study/counted_work.h"
#include "study/setting_words.h"

namespace ps::gui {
namespace {

constexpr const char* own_sweep = "own";
constexpr double least_height_for_legend = 170;  // at scale 1; below, the room is the plot's
constexpr double least_height_for_conclusion = 130;

void choose_named(ChartTabState& state, const NamedSweep& sweep) { set_axes(state.setup, parse_sweep(sweep.key)); }

void follow_document(Session& session, ChartTabState& state) {
  state.sweep.follow(session, [&](const std::string& asked) {
    set_axes(state.setup, parse_sweep_text(asked.empty() ? named_sweeps().front().key : asked));
    state.begun = true;
  });
}

void keep_sweep(Session& session, ChartTabState& state) {
  const std::string shown = sweep_text(state.setup.axes);
  state.sweep.keep(session, shown == named_sweeps().front().key ? "" : shown);
}

/// The first sweep is the one whose points the most people ask for: who draws it, and how well.
void begin(ChartTabState& state) {
  if (state.begun) return;
  state.begun = true;
  if (state.setup.axes.empty()) choose_named(state, named_sweeps().front());
}

/// Why each of the named sweeps changes nothing here; empty for those that do.
void look_for_idle_sweeps(const Session& session, ChartTabState& state) {
  if (state.idle_for == state.plan.key) return;
  state.idle_for = state.plan.key;
  state.idle_sweeps.clear();
  for (const NamedSweep& sweep : named_sweeps())
    state.idle_sweeps.push_back(idle_sweep(sweep, state.plan.base, session.traits()).value_or(""));
}

void sweep_choice(ChartTabState& state, float width) {
  std::vector<Choice> choices;
  for (const NamedSweep& sweep : named_sweeps()) choices.push_back({sweep.key, sweep.label, ""});
  const std::string shown = sweep_text(state.setup.axes);
  const auto named = std::find_if(choices.begin(), choices.end(), [&](const Choice& c) { return c.key == shown; });
  int index = static_cast<int>(named - choices.begin());
  if (named == choices.end()) choices.push_back({own_sweep, "A custom sweep", ""});
  const auto idle = [&state](std::size_t sweep) {
    return sweep < state.idle_sweeps.size() ? state.idle_sweeps[sweep] : "";
  };
  if (!choice("sweep", choices, index,
              {.tooltip = "The sweep: one picture for each combination of values.", .width = width, .idle = idle}))
    return;
  const auto chosen = static_cast<std::size_t>(index);
  if (chosen < named_sweeps().size()) choose_named(state, named_sweeps()[chosen]);
}

void setup_popup(Session& session, ChartTabState& state, const ChartHost& host) {
  if (button("change", "Setup", Emphasis::quiet, {.tooltip = "Options and values, error metric and reference."}))
    ImGui::OpenPopup("chart-setup");
  // It grows upwards from the lower edge, as options are added.
  const float width = px(400), margin = px(8);
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float left = std::max(margin, std::min(ImGui::GetItemRectMin().x, window.x - width - margin));
  ImGui::SetNextWindowPos({left, window.y - margin}, ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, window.y - 2 * margin});
  if (!ImGui::BeginPopup("chart-setup")) return;
  chart_setup_controls(state.setup, state.plan, session, host.browse_reference);
  ImGui::EndPopup();
}

void show_found(ChartTabState& state) {
  state.chart.across = state.across;
  summarise(state.chart, state.metric);
  state.conclusion = chart_conclusion(state.chart).sentence;
}

void metric_choice(ChartTabState& state, float width) {
  std::vector<Choice> choices;
  for (const ErrorMetricRow& row : error_metrics()) choices.push_back({row.key, row.label, ""});
  int index = static_cast<int>(state.metric);
  if (!choice("metric", choices, index, {.tooltip = "The error metric.", .width = width})) return;
  state.metric = static_cast<ErrorMetric>(index);
  if (state.found) show_found(state);
}

/// Milliseconds of this machine, or work counted alike on every machine.
void across_choice(ChartTabState& state, float width) {
  static constexpr std::array choices{
      Choice{"time", "Time", "Milliseconds of one picture on this machine."},
      Choice{"work", "Work", "Rays, intersection tests, fragments and texel reads: the same on every machine."}};
  int index = static_cast<int>(state.across);
  if (!choice("across", choices, index, {.tooltip = "The horizontal axis.", .width = width})) return;
  state.across = static_cast<ChartAcross>(index);
  if (state.found) show_found(state);
}

/// What a click on the button would do.
const char* measure_word(const ChartTabState& state) {
  const bool same = state.measured == state.plan.key && state.found;
  if (same && state.study.state() == StudyState::done) return "Again";
  if (same && state.found && state.study.state() == StudyState::cancelled) return "Resume";
  return state.kept ? "Resume" : "Measure";
}

/// Begins to estimate what Measure will take, if that is not known for what is planned now.
void keep_estimate(Session& session, ChartTabState& state) {
  state.seen.now();
  const std::string wanted = fmt::format("{}|{} runs", state.plan.key, state.setup.repeats);
  if (state.estimated == wanted || state.study.running() || !state.plan.error.empty()) return;
  state.estimated = wanted;
  start_estimate(state.estimate, make_request(state.plan, state.setup, state.metric, session));
}

/// "Measure (about 40 s, 20 pictures)"
std::string measure_label(const ChartTabState& state, const std::string& word) {
  if (word == "Resume" || !state.plan.error.empty()) return word;
  const std::size_t pictures = state.plan.points.size();
  const auto estimate = state.estimate.found();
  if (estimate) return fmt::format("{} ({})", word, estimate_text(*estimate));
  const char* time = state.estimate.state() == StudyState::failed ? "time unknown" : "time not known yet";
  return fmt::format("{} ({}, {} picture{})", word, time, pictures, pictures == 1 ? "" : "s");
}

void run_buttons(Session& session, ChartTabState& state, const StudyFolder& folder, const std::string& label) {
  if (state.study.running()) {
    pause_and_stop(state.study, "Measured points are kept; the study can be resumed.");
    return;
  }
  const std::string word = measure_word(state);
  const bool fits = button_width(label) <= ImGui::GetContentRegionAvail().x;
  if (!button("measure", fits ? label : word, Emphasis::primary,
              {.tooltip = "Renders every picture several times in the background. The time is estimated from small "
                          "pictures of all points and of the reference.",
               .disabled = state.plan.error}))
    return;
  if (word == "Again") StudyFolder::forget(folder.of(state.plan.key));
  measure_chart(session, state, folder);
}

void export_menu(const Session& session, const ChartTabState& state, const ChartHost& host) {
  if (button(
          "export", "Save", Emphasis::quiet,
          {.tooltip = "Saves the chart as a table, as JSON or as a picture, or copies the command that measures it."}))
    ImGui::OpenPopup("chart-export");
  if (!ImGui::BeginPopup("chart-export")) return;
  for (const auto& [name, label, file] :
       {std::array{"csv", "Table (CSV)", "chart.csv"}, std::array{"json", "Everything (JSON)", "chart.json"},
        std::array{"svg", "Picture (SVG)", "chart.svg"}})
    if (menu_item(name, label, {}, false, state.chart.points.empty() ? "nothing is measured yet" : ""))
      host.ask_export(file);
  if (menu_item("command", "Copy as a command")) host.copy(command_of(state.plan, state.setup, state.metric, session));
  ImGui::EndPopup();
}

/// Answers whether to fill the window, or no longer.
bool toolbar(Session& session, ChartTabState& state, const StudyFolder& folder, const ChartHost& host, bool filled) {
  const bool wide = ImGui::GetWindowWidth() >= px(690);
  const float gap = px(wide ? 10 : 3);
  sweep_choice(state, std::min(px(220), ImGui::GetContentRegionAvail().x));
  same_line_if_room(button_width("Setup"), px(3));
  setup_popup(session, state, host);
  keep_estimate(session, state);
  const std::string measure = measure_label(state, measure_word(state));
  same_line_if_room(button_width(state.study.running() ? "Measure" : measure), gap);
  run_buttons(session, state, folder, measure);
  same_line_if_room(px(wide ? 150 : 76), gap);
  metric_choice(state, px(wide ? 150 : 76));
  same_line_if_room(px(76), px(3));
  across_choice(state, px(76));
  same_line_if_room(button_width("Save"), px(3));
  export_menu(session, state, host);
  same_line_if_room(button_width("Fill"), px(3));
  return button_on_off("fill", "Fill", filled, {.tooltip = "Shows the chart in the whole window (Esc)."});
}

/// One line: what is going on, or what the chart is of.
std::string state_line(const ChartTabState& state) {
  const StudyStatus status = state.study.status();
  switch (state.study.state()) {
  case StudyState::running:
    if (status.total == 0)
      return fmt::format("Rendering the reference: {:.0f} %", 100 * state.study.fraction_of_render());
    return status_text(status, "runs");
  case StudyState::paused:
    return "Paused after " + status_text(status, "runs");
  case StudyState::failed:
    return "Failed: " + state.study.message();
  case StudyState::cancelled:
    if (status.total == 0) return "Stopped before the reference was done.";
    return fmt::format("Stopped after {} of {} runs; Resume goes on from there.", status.done, status.total);
  case StudyState::done:
  case StudyState::none:
    break;
  }
  if (!state.found) return state.plan.error.empty() ? "" : state.plan.error;
  const ChartIdentity& id = state.chart.identity;
  const std::string swept = chart_names(state.chart).common;
  std::string text = fmt::format("{}{}{}, {} x {}. {}", swept, swept.empty() ? "" : ". ", id.scene, id.width, id.height,
                                 settings_in_words(chart_provenance(state.chart)));
  if (id.region != "all") text += fmt::format(" Only the rectangle {}.", id.region);
  if (id.values == "linear") text += " Linear values.";
  return text;
}

/// As many whole sentences from the beginning as fit into one line.
std::string sentences_that_fit(const std::string& text, float width) {
  std::string fitting = text;
  while (text_width(fitting) > width) {
    const auto end = fitting.rfind(". ");
    if (end == std::string::npos) break;
    fitting.resize(end + 1);
  }
  return fitting;
}

/// What the chart shows or what the study is at: wrapped where the plot has height to spare, else one line.
void progress_line(const ChartTabState& state) {
  constexpr float enough_height = 320;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float width = room.x;
  const StudyStatus status = state.study.status();
  const std::string text = state_line(state);
  {
    const FontScope small(Face::small);
    const std::string shown =
        room.y >= px(enough_height) && !state.study.running() ? text : sentences_that_fit(text, width);
    ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
    ImGui::TextWrapped("%s", shown.c_str());
    ImGui::PopStyleColor();
    if (shown != text) tooltip(text);
  }
  controls().record("status", text);
  if (!state.study.running()) return;
  const double fraction =
      status.total > 0 ? static_cast<double>(status.done) / status.total : state.study.fraction_of_render();
  auto& list = *ImGui::GetWindowDrawList();
  const float y = ImGui::GetItemRectMax().y;
  list.AddRectFilled({at.x, y}, {at.x + width, y + px(2)}, colour_u32(palette().line));
  list.AddRectFilled({at.x, y}, {at.x + width * static_cast<float>(fraction), y + px(2)},
                     colour_u32(palette().text_quiet));
}

std::optional<std::size_t> showing(const Chart& chart, const Settings& settings) {
  for (std::size_t i = 0; i < chart.points.size(); ++i)
    if (chart.points[i].measured() && chart.points[i].what.value == settings) return i;
  return {};
}

void load_point(Session& session, const ChartPoint& point, Side side) {
  session.set_settings(side, point.what.value, fmt::format("{}: {} (chart)", letter_of(side), point.what.name));
}

/// Height of the sentence under the chart, wrapped.
float conclusion_height(const ChartTabState& state, const Area& area) {
  if (state.conclusion.empty()) return 0;
  ImFont* font = theme().font(Face::body);
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, area.width(), state.conclusion.c_str()).y + px(6);
}

void draw_conclusion(ImDrawList& list, const ChartTabState& state, const Area& area) {
  ImFont* font = theme().font(Face::body);
  list.AddText(font, font->FontSize, {std::round(area.min.x), std::round(area.min.y + px(2))},
               colour_u32(palette().text), state.conclusion.c_str(), nullptr, area.width());
  controls().record("conclusion", state.conclusion);
}

void plot(Session& session, ChartTabState& state, const Area& area) {
  ImGui::SetCursorScreenPos(area.min);
  const bool clicked = ImGui::InvisibleButton("plot", {std::max(area.width(), 1.f), std::max(area.height(), 1.f)},
                                              ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  controls().record("plot", fmt::format("{:.0f}x{:.0f}", area.width(), area.height()));
  gui::values().publish("chart/plot-height", static_cast<int>(area.height()));
  const bool over = ImGui::IsItemHovered();
  const bool any = std::any_of(state.chart.points.begin(), state.chart.points.end(),
                               [](const ChartPoint& p) { return p.measured(); });
  if (!any) return chart_invitation(state, area, measure_word(state));
  auto& list = *ImGui::GetWindowDrawList();
  const float legend = area.height() >= px(least_height_for_legend) ? chart_legend_height() : 0;
  const float conclusion = area.height() >= px(least_height_for_conclusion) ? conclusion_height(state, area) : 0;
  const Area chart_area{area.min, {area.max.x, area.max.y - legend - conclusion}};
  const ChartMarks marks{showing(state.chart, session.settings(Side::a)),
                         showing(state.chart, session.settings(Side::b)), state.hovered};
  const ImVec2 nowhere{-1e6f, -1e6f};
  state.hovered =
      draw_chart(list, chart_area, state.chart, state.labels, marks, over ? ImGui::GetIO().MousePos : nowhere);
  if (conclusion > 0) draw_conclusion(list, state, {{area.min.x, chart_area.max.y}, area.max});
  if (legend > 0) draw_chart_legend(list, {{area.min.x, chart_area.max.y + conclusion}, area.max}, state.chart);
  if (!state.hovered) return;
  const ChartPoint& point = state.chart.points[*state.hovered];
  // Settings belong to their scene: those of one made for another may not fit.
  const bool fits = state.chart.identity.scene == session.document().scene_name;
  const bool right = ImGui::IsMouseReleased(ImGuiMouseButton_Right);
  if (fits) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (fits && clicked) load_point(session, point, right || ImGui::GetIO().KeyShift ? Side::b : Side::a);
  chart_hover(state, point, state.preview,
              fits ? "Click: into A.  Shift or right click: into B." : "Another scene is open now.");
}

}  // namespace

void update_chart(Session& session, ChartTabState& state) {
  drop_unseen_estimate(state);
  const auto found = state.study.found();
  if (!found || found == state.found || !session.has_scene()) return;
  state.found = found;
  state.chart = found->chart;
  show_found(state);
}

bool chart_tab(Session& session, ChartTabState& state, const StudyFolder& folder, const ChartHost& host, bool filled) {
  const NameScope scope("chart");
  if (!session.has_scene()) return false;
  begin(state);
  follow_document(session, state);
  update_plan(state.plan, state.setup, session);
  if (state.kept_for != state.plan.key) {
    state.kept_for = state.plan.key;
    state.kept = StudyFolder::holds_results(folder.of(state.plan.key));
  }
  look_for_idle_sweeps(session, state);
  const bool fill = toolbar(session, state, folder, host, filled);
  keep_sweep(session, state);
  progress_line(state);
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  if (room.x < px(80) || room.y < px(60)) return fill;
  plot(session, state, {{at.x, at.y + px(2)}, {at.x + room.x, at.y + room.y}});
  return fill;
}

void sweep_option(ChartTabState& state, const Option& option, Side side) {
  state.begun = true;
  state.setup.side = side;
  set_axes(state.setup, {{&option, standard_values(option)}});
}

void measure_chart(Session& session, ChartTabState& state, const StudyFolder& folder) {
  begin(state);
  update_plan(state.plan, state.setup, session);
  if (!state.plan.error.empty()) return;
  ChartRequest request = make_request(state.plan, state.setup, state.metric, session);
  request.folder = folder.of(state.plan.key);
  if (state.measured != state.plan.key) {
    state.found = nullptr;
    state.chart = {};
    state.conclusion.clear();
  }
  state.measured = state.plan.key;
  state.kept_for.clear();
  if (state.estimate.running()) {  // it would disturb the times
    state.estimate.cancel();
    state.estimated.clear();
  }
  start_chart(state.study, std::move(request));
}

void export_chart(const ChartTabState& state, const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".csv")
    write_file_atomically(path, chart_csv(state.chart));
  else if (extension == ".json")
    write_file_atomically(path, chart_json(state.chart));
  else if (extension == ".svg")
    write_file_atomically(path, chart_svg(state.chart));
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
    if (what == "standing") return std::string(standing_key(point.standing));
    if (what == "left-out") return fmt::format("{}", fmt::join(point.left_out, "; "));
    if (what == "runs") return script_text(static_cast<int>(point.samples_ms.size()));
  }
  return {};
}

}  // namespace

void offer_chart_values(Values& out, const ChartTabState& state) {
  out.offer_below("chart/of/", [&state](std::string_view name) { return point_value(state.chart, name); });
  out.offer("chart/planned", [&state] { return static_cast<int>(state.plan.points.size()); });
  out.offer("chart/measured", [&state] {
    const auto& points = state.chart.points;
    return static_cast<int>(
        std::count_if(points.begin(), points.end(), [](const ChartPoint& point) { return point.measured(); }));
  });
  out.offer("chart/estimating", [&state] { return state.estimate.running(); });
  out.offer("chart/running", [&state] { return state.study.running(); });
  out.offer("chart/paused", [&state] { return state.study.state() == StudyState::paused; });
  out.offer("chart/runs-done", [&state] { return state.study.status().done; });
  out.offer("chart/truth", [&state] { return state.chart.identity.reference; });
  out.offer("chart/machinery", [&state] { return state.chart.identity.machinery; });
  out.offer("chart/conclusion", [&state] { return state.conclusion; });
  out.offer("chart/hovered",
            [&state] { return state.hovered ? state.chart.points[*state.hovered].what.label : std::string(); });
}

}  // namespace ps::gui
