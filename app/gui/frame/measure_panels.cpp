#include "gui/frame/measure_panels.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/kept_inputs.h"
#include "gui/frame/file_questions.h"
#include "gui/frame/show_panel.h"
#include "gui/widgets/widgets.h"
#include "scene/load.h"

namespace ps::gui {
namespace {

/// Where the chart is written, in the form that the extension names.
void save_chart(Session& session, const ChartTab& chart, const std::filesystem::path& path) {
  try {
    require_no_input(path, files_of(session.document().base));
    chart.write(path);
    session.say(Message::Kind::information, fmt::format("Saved {}.", path.string()));
  } catch (const InputError& error) {
    session.say(Message::Kind::error, error.what());
  }
}

ChartHost chart_host(Session& session, ChartTab& chart, const PanelHost& host) {
  return {.browse_reference =
              [&] {
                host.ask_file(
                    {.title = "Compare with a picture",
                     .use = FileUse::open,
                     .extensions = {".png", ".ppm", ".pfm"},
                     .hint = "picture.png",
                     .answer = [&](const FileAnswer& file) { chart.setup.reference_file = file.path.string(); }});
              },
          .ask_export =
              [&](const std::string& name) {
                host.ask_file({.title = "Save the chart",
                               .extensions = {".csv", ".json", ".svg"},
                               .hint = "chart.svg",
                               .suggestion = name,
                               .answer = [&](const FileAnswer& file) { save_chart(session, chart, file.path); }});
              },
          .copy = [&](const std::string& text) { host.copy(text, "The command is on the clipboard."); }};
}

/// A row with what all studies have in common. `tab` draws one of `studies` at a time.
template <class Tab>
Panel study_panel(Session& session, Tab& tab, const std::vector<StudyFrame*>& studies, Panel row) {
  row.use = PanelUse::study;
  row.height = PanelHeight::tall;
  row.draw = [&session, &tab, name = row.name](const Context& context) {
    const NameScope scope(name);
    return tab.draw(session, context.filled);
  };
  row.publish = [studies](Values& out) {
    for (const StudyFrame* study : studies) study->offer(out);
  };
  row.update = [studies, &session] {
    for (StudyFrame* study : studies) study->update(session);
  };
  row.busy = [studies] {
    return std::any_of(studies.begin(), studies.end(), [](const StudyFrame* study) { return study->busy(); });
  };
  row.status = [studies] {
    std::string text;
    for (const StudyFrame* study : studies)
      if (text.empty()) text = study->activity();
    return text;
  };
  return row;
}

Panel study_panel(Session& session, StudyFrame& study, const Panel& row) {
  return study_panel(session, study, {&study}, row);
}

}  // namespace

std::vector<Panel> measure_panels(Session& session, PanelStates& my, const PanelHost& host) {
  my.chart.host = chart_host(session, my.chart, host);
  my.stability.sweep = [&session, &my](const Option& option, Side side) {
    my.chart.sweep_option(option, side);
    show_panel(session, tool_names::chart);
  };
  return {study_panel(session, my.chart,
                      {.name = tool_names::chart,
                       .group = ToolGroup::measure,
                       .heading = "CHART",
                       .brief = "Chart",
                       .command = "Chart: time against error",
                       .help = "Time against error over a sweep of options."}),
          study_panel(session, my.stability,
                      {.name = tool_names::stability,
                       .group = ToolGroup::stability,
                       .heading = "STABILITY",
                       .brief = "Stable",
                       .command = "Stability: where methods fail",
                       .help = "Where methods fail: naive beside robust."}),
          study_panel(session, my.needs,
                      {.name = tool_names::needs,
                       .group = ToolGroup::measure,
                       .heading = "NEEDS",
                       .brief = "Needs",
                       .command = "Needs: what the scene can do without",
                       .help = "The features that this scene needs, and the cheapest settings within a tolerance."}),
          study_panel(session, my.why, {&my.why.causes, &my.why.precision},
                      {.name = tool_names::why,
                       .group = ToolGroup::measure,
                       .heading = "WHY",
                       .brief = "Why",
                       .command = "Why: what makes A and B differ",
                       .help = "Which option makes A and B differ, and which pixels float gets wrong."}),
          study_panel(session, my.timings,
                      {.name = tool_names::timings,
                       .group = ToolGroup::measure,
                       .heading = "TIMINGS",
                       .brief = "Times",
                       .command = "Timings: times and counts",
                       .help = "Times of the stages and counts of the work, A beside B."})};
}

}  // namespace ps::gui
