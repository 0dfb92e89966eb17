#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "base/check.h"
#include "base/enumerators.h"
#include "base/kept_inputs.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/scene_arguments.h"
#include "document/number_list.h"
#include "number_option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "study/chart.h"
#include "study/chart_conclusion.h"
#include "study/chart_files.h"
#include "study/chart_style.h"
#include "study/counted_work.h"
#include "study/missing_points.h"
#include "study/model/model_sweep.h"
#include "study/renderer_sweep.h"

namespace ps::cli {
namespace {

struct ChartArguments {
  SceneArguments scene;
  std::vector<std::string> folders;
  std::vector<std::string> sweeps;
  std::string metric = "rmse", across = "time", region, reference, shard = "1/1", output;
  int repeats = 5, samples = 0;
  bool linear = false, as_used = false;
};

ChartRequest make_request(const ChartArguments& arguments) {
  ChartRequest request;
  request.shard = parse_shard(arguments.shard);
  request.error.metric = parse_error_metric(arguments.metric);
  request.error.values = arguments.linear ? ErrorValues::linear : ErrorValues::display;
  if (!arguments.region.empty()) request.error.region = parse_region_text(arguments.region);
  request.reference = {arguments.reference, arguments.samples};
  request.machinery = arguments.as_used ? MachineryRule::as_used : MachineryRule::same;
  request.across = parse_enumerator<ChartAcross>("across", arguments.across);
  request.repeats = arguments.repeats;
  request.folder = arguments.output;
  bool model = std::find(arguments.sweeps.begin(), arguments.sweeps.end(), model_sweep_key) != arguments.sweeps.end();
  if (model && arguments.sweeps.size() > 1)
    throw InputError(fmt::format("--sweep {}: the model is swept alone", model_sweep_key));
  std::vector<SweepAxis> axes;
  if (!model)
    for (const std::string& sweep : arguments.sweeps)
      for (SweepAxis& axis : parse_sweep(sweep)) axes.push_back(std::move(axis));
  const Document document = load_document(arguments.scene);
  if (arguments.sweeps.empty() && !document.layout.sweep.empty()) {
    axes = parse_sweep_text(document.layout.sweep);
    model = document.layout.sweep == model_sweep_key;
  }
  request.scene = document.scene;
  request.scene.name = document.scene_name;
  request.view = view_of(document);
  request.base = document.a.settings;
  if (model) {
    StudyControl control;
    forward_interrupts(control.progress());
    request.points = model_sweep(request, settings_for(document.base), control);
    return request;
  }
  const SceneTraits traits = scene_traits(request.scene);
  for (const std::string& sweep : arguments.sweeps)  // of options that are asked for by one name, some may be idle
    if (const auto idle = idle_axes_all(parse_sweep(sweep), axes, request.base, traits))
      throw InputError(fmt::format("--sweep {}: {}", sweep, *idle));
  for (const std::string& sentence : idle_axes(axes, request.base, traits)) fmt::print(stderr, "{}\n", sentence);
  request.absent = absent_renderers(axes);
  request.points = sweep_points(axes, request.base, settings_for(document.base), traits);
  return request;
}

constexpr int incomplete = 1;  // exit status

void print_damage(const Chart& chart) {
  for (const std::string& sentence : chart.damage) fmt::print(stderr, "pixelscope-cli: {}\n", sentence);
}

void print_status(const StudyStatus& status) {
  if (isatty(STDERR_FILENO) == 0) return;
  const std::string left = status.seconds_left < 0 ? "" : fmt::format(", {:.0f} s left", status.seconds_left);
  fmt::print(stderr, "\r{} of {} runs{}   ", status.done, status.total, left);
  if (status.done == status.total) fmt::print(stderr, "\n");
}

/// A column of its own where a graphics driver drew some of the points; otherwise empty.
std::string upload_column(const Chart& chart, std::string_view text) {
  const bool shown = std::any_of(chart.points.begin(), chart.points.end(),
                                 [](const ChartPoint& point) { return point.upload_ms.has_value(); });
  return shown ? fmt::format(" {:>11}", text) : "";
}

void print_table(const Chart& chart) {
  fmt::print("{:>11} {:>11} {:>11}{} {:>12} {:>10} {:>11}    {}\n", "time ms", "quartile 1", "quartile 3",
             upload_column(chart, "upload ms"), "work", error_metric(chart.metric).key, "memory MB",
             "point (* on the front, ~ a tie with it)");
  for (const ChartPoint& point : chart.points) {
    if (!point.measured()) {
      fmt::print("{:>11} {:>11} {:>11}{} {:>12} {:>10} {:>11}    {}: not measured\n", "-", "-", "-",
                 upload_column(chart, "-"), "-", "-", "-",
                 point.what.label.empty() ? fmt::format("point {}", point.number) : point.what.label);
      continue;
    }
    const std::string upload = point.upload_ms ? fmt::format("{:.4g}", point.upload_ms->median) : "-";
    const std::string error = point.standing == Standing::truth ? "truth" : fmt::format("{:.4g}", point.error);
    fmt::print("{:>11.4g} {:>11.4g} {:>11.4g}{} {:>12} {:>10} {:>11.4g}  {} {}\n", point.time_ms.median,
               point.time_ms.q1, point.time_ms.q3, upload_column(chart, upload), work_text(point.work), error,
               point.memory_mb,
               point.tie        ? '~'
               : point.on_front ? '*'
                                : ' ',
               point.what.label);
  }
  fmt::print("{}\n", chart_provenance(chart));
  const std::string conclusion = chart_conclusion(chart).sentence;
  if (!conclusion.empty()) fmt::print("{}\n", conclusion);
}

int run_merge(const ChartArguments& arguments) {
  if (arguments.folders.empty()) throw InputError("chart merge: found no folder, expected those of the shards");
  Chart chart =
      merge_charts({arguments.folders.begin(), arguments.folders.end()}, parse_error_metric(arguments.metric));
  chart.across = parse_enumerator<ChartAcross>("across", arguments.across);
  summarise(chart, chart.metric);
  std::filesystem::create_directories(arguments.output);
  write_chart(arguments.output, chart);
  print_table(chart);
  print_damage(chart);
  const std::string missing = missing_text(chart);
  if (!missing.empty()) fmt::print(stderr, "pixelscope-cli: incomplete: {}\n", missing);
  return missing.empty() && chart.damage.empty() ? 0 : incomplete;
}

/// A chart's folder must not be one whose files of the same names the scene is made of.
void require_own_folder(const ChartRequest& request) {
  const std::vector<std::string> inputs = files_of(request.scene);
  for (const std::string& input : inputs) {
    const std::filesystem::path name = std::filesystem::path(input).filename();
    const bool is_ours = name == "runs.jsonl" || name == "points.csv" || name == "points.json" || name == "chart.svg" ||
                         name == "reference.png" ||
                         (name.string().starts_with("picture-") && name.extension() == ".png");
    if (is_ours) require_no_input(request.folder / name, inputs);
  }
}

int run_chart_command(const ChartArguments& arguments) {
  if (arguments.scene.scene == "merge") return run_merge(arguments);
  if (!arguments.folders.empty())
    throw InputError(fmt::format("chart: found '{}' after the scene, expected options", arguments.folders.front()));
  const ChartRequest request = make_request(arguments);
  require_own_folder(request);
  StudyControl control;
  forward_interrupts(control.progress());
  bool begun = false;
  const Chart chart = run_chart(request, control, [&](const Chart& so_far, const StudyStatus& status) {
    if (!begun) print_damage(so_far);  // what is missing is measured again
    begun = true;
    print_status(status);
  });
  write_chart(arguments.output, chart);
  print_table(chart);
  return 0;
}

}  // namespace

void add_chart_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("chart", "measure time against error over a sweep of options");
  const auto arguments = std::make_shared<ChartArguments>();
  add_scene_arguments(*command, arguments->scene);
  command->add_option("FOLDER", arguments->folders, "with 'merge' instead of SCENE: folders of shards to merge");
  std::string sweeps;
  for (const NamedSweep& sweep : named_sweeps()) sweeps += fmt::format(" {}", sweep.key);
  sweeps += fmt::format(" {}, the model from full to reduced", model_sweep_key);
  command
      ->add_option("--sweep", arguments->sweeps,
                   "an option with its values (none: all, or a selection); several options make their product; "
                   "default: that of the permalink; or one of:" +
                       sweeps)
      ->type_name("KEY[=V1,V2..]")
      ->allow_extra_args(false);
  command->add_option("--metric", arguments->metric, "mae rmse psnr max ssim or flip");
  command->add_option("--across", arguments->across, "the horizontal axis: time, counted work, or memory");
  command->add_flag("--as-used", arguments->as_used,
                    "time each point as the window renders it; default: all run on the same code, SIMD or scalar");
  command->add_flag("--linear", arguments->linear, "compare unit floats instead of display levels");
  command->add_option("--region", arguments->region, "compare only this rectangle")->type_name("X,Y,W,H");
  command->add_option("--repeats", arguments->repeats, "number of timed runs of each point")
      ->check(whole_number_from(1, 1000));
  command->add_option("--reference", arguments->reference, "a picture to compare with; default: one is rendered");
  command
      ->add_option("--reference-samples", arguments->samples,
                   "samples per pixel of the rendered reference, a square number; 1 = the points' own samples; "
                   "default: as the swept options need")
      ->check(whole_number_from(1, 4096));
  command->add_option("--shard", arguments->shard, "only part i of n of the sweep")->type_name("i/n");
  command->add_option("--out", arguments->output, "folder for the results; an interrupted run continues there")
      ->required();
  command->callback([&chosen, arguments] { chosen = [arguments] { return run_chart_command(*arguments); }; });
}

}  // namespace ps::cli
