#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/machine.h"
#include "base/standard_output.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/output_file.h"
#include "image/file.h"
#include "number_option.h"
#include "render/provenance.h"
#include "study/stability/figures.h"
#include "study/stability/pictures.h"
#include "study/stability_study.h"

namespace ps::cli {
namespace {

struct StabilityArguments {
  std::vector<std::string> names;
  std::string output, strip;
  std::uint32_t seed = 1;
  double effort = 1;
  bool resume = false;
};

/// "-" where the series has no such method.
std::string measured_text(double value) { return std::isnan(value) ? "-" : fmt::format("{:.4g}", value); }

void print_rows(const StabilityExperiment& experiment, const std::vector<StabilityRow>& rows) {
  fmt::print("{} ({})\n{}\n", experiment.title, experiment.key, experiment.explanation);
  fmt::print("naive: {}; robust: {}; safe: {}\n", experiment.naive, experiment.robust, experiment.safe);
  if (const auto set_up = set_up_text(experiment.set_up); !set_up.empty()) fmt::print("{}\n", set_up);
  fmt::print("{}\n", first_figure_text(experiment, rows));
  fmt::print("{:>12} {:>12} {:>12}  {}\n", "knob", "naive", "robust", experiment.knob);
  for (const StabilityRow& row : rows) {
    const StabilitySeries& quantity = quantity_of(experiment, row.series);
    const std::string_view value = case_name(quantity, row.knob);
    fmt::print("{:>12.4g} {:>12} {:>12}  {}{}{}: {}\n", row.knob, measured_text(row.naive), measured_text(row.robust),
               row.series, value.empty() ? "" : ", ", value, row.unit);
  }
  fmt::print("\n");
}

Provenance study_provenance(const StabilityArguments& arguments) {
  return provenance_of(this_machine(), fmt::format("seed={};effort={}", arguments.seed, arguments.effort));
}

int save_strip(const std::vector<const StabilityExperiment*>& chosen, const std::string& file) {
  if (chosen.size() != 1) throw InputError("--strip: expected the name of one experiment");
  require_output_file(file, OutputKind::levels);
  const auto strip = film_strip(*chosen.front(), {}, interruptible_progress());
  if (!strip) throw InputError(fmt::format("--strip: {} has no picture", chosen.front()->key));
  Provenance made = provenance_of(Settings{});
  made.more = {{"experiment", std::string(chosen.front()->key)}};
  save_image(file, *strip, {image_texts(made)});
  fmt::print("from left to right, {}: {}\n", knob_title(*chosen.front(), chosen.front()->series.front()),
             fmt::join(chosen.front()->frames, ", "));
  fmt::print("above: {}; below: {}; at the bottom, white: where they differ\n", chosen.front()->naive,
             chosen.front()->robust);
  return 0;
}

int run_stability(const StabilityArguments& arguments) {
  std::vector<const StabilityExperiment*> chosen;
  for (const std::string& name : arguments.names) chosen.push_back(&find_stability_experiment(name));
  if (chosen.empty())
    for (const StabilityExperiment& experiment : stability_experiments()) chosen.push_back(&experiment);
  if (!arguments.strip.empty()) return save_strip(chosen, arguments.strip);
  const bool kept = !arguments.output.empty();
  if (!kept && arguments.resume) throw InputError("--resume: expected --out FOLDER with what was measured before");
  if (kept) make_folder(arguments.output);
  const Provenance made = study_provenance(arguments);
  fmt::print("{}, {}, {}, {} threads, {}\n\n", made.program, made.processor, made.simd, made.threads, made.settings);
  StabilityRequest request;
  for (const StabilityExperiment* experiment : chosen) request.keys.emplace_back(experiment->key);
  request.seed = arguments.seed;
  request.effort = arguments.effort;
  request.folder = arguments.output;
  request.kept = arguments.resume ? StabilityRequest::Kept::take : StabilityRequest::Kept::measure_again;
  StudyControl control;
  forward_interrupts(control.progress());
  run_stability(request, control, [&](const MeasuredExperiment& measured, const StudyStatus&) {
    const StabilityExperiment& experiment = find_stability_experiment(measured.key);
    if (!measured.absent.empty())
      fmt::print("{} ({})\nnot measured: {}\n\n", experiment.title, experiment.key, measured.absent);
    if (!measured.complete) return;
    if (kept)
      write_file_atomically(std::filesystem::path(arguments.output) / fmt::format("{}.csv", measured.key),
                            stability_csv_with_meaning(csv_with_provenance(stability_csv(measured.rows), made),
                                                       experiment, measured.rows));
    print_rows(experiment, measured.rows);
    require_printed();  // measuring takes minutes, and its progress should be visible
  });
  return 0;
}

}  // namespace

void add_stability_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("stability", "measure where methods fail: naive beside robust");
  const auto arguments = std::make_shared<StabilityArguments>();
  std::string names;
  for (const StabilityExperiment& experiment : stability_experiments()) names += fmt::format(" {}", experiment.key);
  command->add_option("NAME", arguments->names, "names of experiments (default: all):" + names);
  command->add_option("--out", arguments->output, "folder for NAME.csv and for rows as they are measured");
  command->add_flag("--resume", arguments->resume,
                    "skip experiments that the folder already has for this seed and effort");
  command->add_option("--strip", arguments->strip, "write the pictures of one experiment over its knob to this file");
  command->add_option("--effort", arguments->effort, "fraction of the full number of rays, triangles and pixels")
      ->check(number_from(0.001, 10));
  command->add_option("--seed", arguments->seed, "seed of the random numbers")
      ->check(whole_number_from(0, std::numeric_limits<std::uint32_t>::max()));
  command->callback([&chosen, arguments] { chosen = [arguments] { return run_stability(*arguments); }; });
}

}  // namespace ps::cli
