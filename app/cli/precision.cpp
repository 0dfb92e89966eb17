#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "base/kept_inputs.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/output_file.h"
#include "cli/scene_arguments.h"
#include "document/document_provenance.h"
#include "image/file.h"
#include "render/provenance_json.h"
#include "scene/load.h"
#include "study/precision_map.h"
#include "study/unsafe_settings.h"

namespace ps::cli {
namespace {

struct PrecisionArguments {
  SceneArguments scene;
  std::string faults, gap;
  bool json = false;
};

int run_precision(const PrecisionArguments& arguments) {
  for (const std::string& file : {arguments.faults, arguments.gap})
    if (!file.empty()) require_output_file(file, OutputKind::levels);
  const Document document = load_document(arguments.scene);
  for (const std::string& file : {arguments.faults, arguments.gap}) require_no_input(file, files_of(document.scene));
  const View view = view_of(document);
  Prepared prepared;
  Progress& progress = interruptible_progress();
  const PrecisionMap map = precision_map(document.scene, view, document.a.settings, prepared, progress);
  const Provenance made = document_provenance(document, Side::a);
  const SaveOptions options{image_texts(made)};
  if (!arguments.faults.empty()) save_image(arguments.faults, fault_picture(map), options);
  if (!arguments.gap.empty()) save_image(arguments.gap, gap_picture(map), options);
  std::uint64_t confused = 0;
  for (const float gap : map.gap.pixels()) confused += gap < 1 ? 1 : 0;
  const std::vector<UnsafeSetting> unsafe = unsafe_settings(document.scene, view, document.a.settings, progress);
  if (arguments.json) {
    nlohmann::ordered_json json{{"scene", document.scene_name}, {"pixels", view.width * view.height}};
    for (std::size_t i = 0; i < precision_fault_count; ++i)
      json["faults"][std::string(precision_fault_label(static_cast<PrecisionFault>(i)))] = map.counts[i];
    json["depth-values-equal"] = confused;
    json["unsafe-settings"] = nlohmann::ordered_json::array();
    for (const UnsafeSetting& s : unsafe)
      json["unsafe-settings"].push_back({{"option", s.option},
                                         {"value", s.value},
                                         {"experiment", s.experiment},
                                         {"safe", s.safe},
                                         {"bad-percent", s.bad_percent}});
    json["provenance"] = provenance_json(made);
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return 0;
  }
  const double pixels = static_cast<double>(map.faults.pixels().size());
  for (std::size_t i = 0; i < precision_fault_count; ++i)
    fmt::print("{:<16} {:>9} pixels {:>8.3f} %\n", precision_fault_label(static_cast<PrecisionFault>(i)), map.counts[i],
               100 * static_cast<double>(map.counts[i]) / pixels);
  fmt::print("{:<16} {:>9} pixels whose first two surfaces have the same stored depth\n", "z-fighting", confused);
  for (const UnsafeSetting& s : unsafe)
    fmt::print("unsafe: {}={} leaves the window of {}: {:.3f} % of pixels bad; {} is safe\n", s.option, s.value,
               s.experiment, s.bad_percent, s.safe);
  return 0;
}

}  // namespace

void add_precision_command(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("precision", "render again in double and count the pixels that float gets wrong");
  const auto arguments = std::make_shared<PrecisionArguments>();
  add_scene_arguments(*command, arguments->scene);
  command->add_option("--out", arguments->faults, "write a picture of the kinds of faults to this file");
  command->add_option(
      "--gap", arguments->gap,
      "write a picture of the gap between first and second depth, in ulp of the stored depth, to this file");
  command->add_flag("--json", arguments->json, "as JSON");
  command->callback([&chosen, arguments] { chosen = [arguments] { return run_precision(*arguments); }; });
}

}  // namespace ps::cli
