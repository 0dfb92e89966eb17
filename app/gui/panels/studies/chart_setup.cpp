#include "gui/panels/studies/chart_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/check.h"
#include "base/machine.h"
#include "document/command_line.h"
#include "document/number_list.h"
#include "gui/panels/studies/study.h"
#include "options/scene_settings.h"
#include "study/renderer_sweep.h"

namespace ps::gui {
namespace {

constexpr std::size_t most_points = 400;  // more belong on a cluster, in shards

std::string axes_text(const ChartSetup& setup) {
  std::string text(setup.swept == Swept::model ? model_sweep_key : "");
  for (const SweepAxis& axis : setup.axes) text += fmt::format("{}={};", axis.option->key, fmt::join(axis.values, ","));
  return text;
}

/// Whether two settings differ at most in the swept options.
bool same_but_for(const std::vector<SweepAxis>& axes, const Settings& a, Settings b) {
  for (const SweepAxis& axis : axes) axis.option->set(b, axis.option->get(a));
  return a == b;
}

std::string plan_key(const ChartSetup& setup, const Settings& base, const Session& session) {
  static const Machine machine = this_machine();
  const View view = session.view();
  std::string key =
      fmt::format("{} {} {}|{}|{}x{}|{}|base {}|", machine.version, machine.processor, machine.threads,
                  scene_key(session), view.width, view.height, axes_text(setup), fmt::join(changed_options(base), ";"));
  key += setup.values == ErrorValues::display ? "display" : "linear";
  key += setup.machinery == MachineryRule::same ? "" : "|as used";
  if (const auto& region = session.region(); region && setup.part == ChartPart::rectangle)
    key += fmt::format("|{},{},{},{}", region->x0, region->y0, region->x1, region->y1);
  return key + (setup.reference_file.empty() ? fmt::format("|{} samples", setup.reference_samples)
                                             : "|" + setup.reference_file);
}

}  // namespace

void set_axes(ChartSetup& setup, std::vector<SweepAxis> axes) {
  setup.swept = Swept::options;
  setup.axes = std::move(axes);
  setup.typed.clear();
  for (const SweepAxis& axis : setup.axes) setup.typed.push_back(fmt::format("{}", fmt::join(axis.values, ",")));
}

std::string swept_text(const ChartSetup& setup) {
  return setup.swept == Swept::model ? std::string(model_sweep_key) : sweep_text(setup.axes);
}

void update_plan(ChartPlan& plan, const ChartSetup& setup, const Session& session) {
  const Settings& now = session.settings(setup.side);
  const Settings base = !plan.key.empty() && same_but_for(setup.axes, plan.base, now) ? plan.base : now;
  std::string key = plan_key(setup, base, session);
  if (key == plan.key) return;
  plan = {};
  plan.key = std::move(key);
  plan.base = base;
  try {
    if (const auto idle = idle_axes_all(setup.axes, setup.axes, base, session.traits())) throw InputError(*idle);
    if (setup.swept == Swept::options)
      plan.points = sweep_points(setup.axes, base, settings_for(session.document().base), session.traits());
    const ReferenceOptions reference{setup.reference_file, setup.reference_samples};
    plan.truth = setup.reference_file.empty()
                     ? plan_reference(plan.points, base, session.traits(), session.view(), reference).description()
                     : "the picture " + setup.reference_file;
    plan.notes = idle_axes(setup.axes, base, session.traits());
    plan.absent = absent_renderers(setup.axes);
    for (const std::string& absent : plan.absent) plan.notes.push_back(fmt::format("Not drawn: {}.", absent));
    if (plan.points.size() > most_points) {
      plan.error =
          fmt::format("{} points take too long here; 'pixelscope-cli chart --shard' divides them among machines.",
                      plan.points.size());
      plan.points.clear();
    }
  } catch (const InputError& error) {
    plan.error = error.what();
  }
}

ChartRequest make_request(const ChartPlan& plan, const ChartSetup& setup, ErrorMetric metric, const Session& session) {
  ChartRequest request;
  request.scene = session.scene();
  request.scene.name = session.document().scene_name;
  request.view = session.view();
  request.base = plan.base;
  request.points = plan.points;
  request.absent = plan.absent;
  request.error = {metric, setup.values, {}};
  if (setup.part == ChartPart::rectangle) request.error.region = session.region();
  request.reference = {setup.reference_file, setup.reference_samples};
  request.machinery = setup.machinery;
  request.repeats = setup.repeats;
  request.priority = WorkerPriority::background;
  return request;
}

std::string command_of(const ChartPlan& plan, const ChartSetup& setup, ErrorMetric metric, const Session& session) {
  std::vector<std::string> arguments;
  if (setup.swept == Swept::model) arguments = {"--sweep", std::string(model_sweep_key)};
  for (const SweepAxis& axis : setup.axes) {
    arguments.emplace_back("--sweep");
    arguments.push_back(fmt::format("{}={}", axis.option->key, fmt::join(axis.values, ",")));
  }
  const auto add = [&](std::string name, std::string value) {
    arguments.push_back(std::move(name));
    arguments.push_back(std::move(value));
  };
  add("--metric", std::string(error_metric(metric).key));
  if (setup.values == ErrorValues::linear) arguments.emplace_back("--linear");
  if (const auto& r = session.region(); r && setup.part == ChartPart::rectangle) add("--region", region_text(*r));
  add("--repeats", std::to_string(setup.repeats));
  if (setup.machinery == MachineryRule::as_used) arguments.emplace_back("--as-used");
  if (!setup.reference_file.empty())
    add("--reference", setup.reference_file);
  else if (setup.reference_samples > 0)
    add("--reference-samples", std::to_string(setup.reference_samples));
  Document document = session.document();
  side_of(document, setup.side).settings = plan.base;
  return chart_command(document, setup.side, arguments);
}

}  // namespace ps::gui
