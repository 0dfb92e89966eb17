#include "gui/frame/measure_panels.h"

#include <fmt/format.h>

#include "base/kept_inputs.h"
#include "gui/frame/file_questions.h"
#include "gui/panels/studies/timings_panel.h"
#include "scene/load.h"

namespace ps::gui {
namespace {

/// Where the chart is written, in the form that the extension names.
void save_chart(Session& session, const ChartTabState& chart, const std::filesystem::path& path) {
  try {
    require_no_input(path, files_of(session.document().base));
    export_chart(chart, path);
    session.say(Message::Kind::information, fmt::format("Saved {}.", path.string()));
  } catch (const InputError& error) {
    session.say(Message::Kind::error, error.what());
  }
}

ChartHost chart_host(Session& session, PanelStates& my, const PanelHost& host) {
  return {.browse_reference =
              [&] {
                host.ask_file(
                    {.title = "Compare with a picture",
                     .use = FileUse::open,
                     .extensions = {".png", ".ppm", ".pfm"},
                     .hint = "picture.png",
                     .answer = [&](const FileAnswer& file) { my.chart.setup.reference_file = file.path.string(); }});
              },
          .ask_export =
              [&](const std::string& name) {
                host.ask_file({.title = "Save the chart",
                               .extensions = {".csv", ".json", ".svg"},
                               .hint = "chart.svg",
                               .suggestion = name,
                               .answer = [&](const FileAnswer& file) { save_chart(session, my.chart, file.path); }});
              },
          .copy = [&](const std::string& text) { host.copy(text, "The command is on the clipboard."); }};
}

/// The pictures' own renders come first.
template <class Study>
void hold_while_rendering(Session& session, Study& study) {
  study.set_held(session.rendering());
}

std::string chart_status(const ChartTabState& chart) {
  if (chart.study.state() != StudyState::running) return {};
  const StudyStatus status = chart.study.status();
  return status.total > 0 ? "Chart: " + status_text(status, "runs") : "Chart: rendering the reference";
}

Panel chart(Session& session, PanelStates& my, const PanelHost& host) {
  return {.name = tool_names::chart,
          .use = PanelUse::study,
          .group = ToolGroup::measure,
          .height = PanelHeight::tall,
          .heading = "CHART",
          .brief = "Chart",
          .command = "Chart: time against error",
          .help = "Time against error over a sweep of options.",
          .draw = [&, asks = chart_host(session, my, host)](
                      const Context& context) { return chart_tab(session, my.chart, my.folder, asks, context.filled); },
          .publish = [&](Values& out) { offer_chart_values(out, my.chart); },
          .update =
              [&] {
                hold_while_rendering(session, my.chart.study);
                hold_while_rendering(session, my.chart.estimate);
                update_chart(session, my.chart);
              },
          .busy = [&] { return my.chart.study.state() == StudyState::running || my.chart.estimate.running(); },
          .status = [&] { return chart_status(my.chart); }};
}

std::string stability_status(const StabilityTabState& stability) {
  if (stability.study.state() == StudyState::running)
    return "Stability: " + status_text(stability.study.status(), "experiments");
  return stability.opening.running() ? "Stability: opening a point" : "";
}

Panel stability(Session& session, PanelStates& my) {
  return {.name = tool_names::stability,
          .use = PanelUse::study,
          .group = ToolGroup::stability,
          .height = PanelHeight::tall,
          .heading = "STABILITY",
          .brief = "Stable",
          .command = "Stability: where methods fail",
          .help = "Where methods fail: naive beside robust.",
          .draw = [&](const Context& context) { return stability_tab(session, my.stability, context.filled); },
          .publish = [&](Values& out) { offer_stability_values(out, my.stability); },
          .update =
              [&] {
                hold_while_rendering(session, my.stability.study);
                update_stability(session, my.stability, my.folder.scenes());
              },
          .busy = [&] { return stability_busy(my.stability); },
          .status = [&] { return stability_status(my.stability); }};
}

Panel needs(Session& session, PanelStates& my) {
  return {.name = tool_names::needs,
          .use = PanelUse::study,
          .group = ToolGroup::measure,
          .height = PanelHeight::tall,
          .heading = "NEEDS",
          .brief = "Needs",
          .command = "Needs: what the scene can do without",
          .help = "The features that this scene needs, and the cheapest settings within a tolerance.",
          .draw = [&](const Context& context) { return needs_tab(session, my.needs, context.filled); },
          .publish = [&](Values& out) { offer_needs_values(out, my.needs); },
          .update =
              [&] {
                hold_while_rendering(session, my.needs.study);
                hold_while_rendering(session, my.needs.estimate);
                update_needs(my.needs);
              },
          .busy = [&] { return my.needs.study.state() == StudyState::running || my.needs.estimate.running(); },
          .status =
              [&] {
                return my.needs.study.state() == StudyState::running
                           ? fmt::format("Needs: {} pictures tried", my.needs.study.status().done)
                           : "";
              }};
}

Panel why(Session& session, PanelStates& my) {
  return {.name = tool_names::why,
          .use = PanelUse::study,
          .group = ToolGroup::measure,
          .height = PanelHeight::tall,
          .heading = "WHY",
          .brief = "Why",
          .command = "Why: what makes A and B differ",
          .help = "Which option makes A and B differ, and which pixels float gets wrong.",
          .draw = [&](const Context& context) { return why_tab(session, my.why, context.filled); },
          .publish = [&](Values& out) { offer_why_values(out, my.why); },
          .update =
              [&] {
                hold_while_rendering(session, my.why.causes);
                update_why(my.why);
              },
          .busy = [&] { return my.why.running(); },
          .status = [&] { return why_status(my.why); }};
}

Panel timings(Session& session, PanelStates& my) {
  return {.name = tool_names::timings,
          .use = PanelUse::study,
          .group = ToolGroup::measure,
          .height = PanelHeight::tall,
          .heading = "TIMINGS",
          .brief = "Times",
          .command = "Timings: times and counts",
          .help = "Times of the stages and counts of the work, A beside B.",
          .draw =
              [&](const Context&) {
                timings_panel(session, my.timings);
                return false;
              },
          .publish = [&](Values& out) { offer_timings_values(out, my.timings); },
          .update =
              [&] {
                hold_while_rendering(session, my.timings.study);
                update_timings(session, my.timings);
              },
          .busy = [&] { return my.timings.study.running(); },
          .status =
              [&] {
                return my.timings.study.running() ? "Timings: " + status_text(my.timings.study.status(), "runs") : "";
              }};
}

}  // namespace

std::vector<Panel> measure_panels(Session& session, PanelStates& my, const PanelHost& host) {
  return {chart(session, my, host), stability(session, my), needs(session, my), why(session, my), timings(session, my)};
}

}  // namespace ps::gui
