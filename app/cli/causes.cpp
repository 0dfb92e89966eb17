#include <fmt/format.h>

#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/scene_arguments.h"
#include "document/document_provenance.h"
#include "number_option.h"
#include "options/option.h"
#include "render/provenance_json.h"
#include "study/difference_by_cause.h"

namespace ps::cli {
namespace {

struct CausesArguments {
  SceneArguments scene;
  std::vector<std::string> settings_b;
  std::string metric = "rmse";
  int orders = CauseRequest{}.orders;
  std::uint32_t seed = 1;
  bool json = false;
};

void print_json(const CausesArguments& arguments, const DifferenceByCause& result, const nlohmann::ordered_json& made) {
  nlohmann::ordered_json json{
      {"scene", arguments.scene.scene}, {"metric", result.metric},           {"total", result.total},
      {"renders", result.renders},      {"every-order", result.every_order}, {"seed", arguments.seed}};
  json["causes"] = nlohmann::ordered_json::array();
  for (const CauseShare& cause : result.causes) {
    nlohmann::ordered_json row{{"option", cause.option}, {"from", cause.from},   {"to", cause.to},
                               {"share", cause.share},   {"alone", cause.alone}, {"without", cause.without}};
    if (!cause.note.empty()) row["note"] = cause.note;
    json["causes"].push_back(std::move(row));
  }
  json["provenance"] = made;
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

int run_causes(const CausesArguments& arguments) {
  Settings trial;
  for (const std::string& assignment : arguments.settings_b) parse_assignment(assignment, trial);
  const Document document = load_document(arguments.scene);
  Settings b = document.a.settings;
  for (const std::string& assignment : arguments.settings_b) parse_assignment(assignment, b);
  CauseRequest request;
  request.scene = document.scene;
  request.view = view_of(document);
  request.a = document.a.settings;
  request.b = b;
  request.error.metric = parse_error_metric(arguments.metric);
  request.orders = arguments.orders;
  request.seed = arguments.seed;
  StudyControl control;
  forward_interrupts(control.progress());
  const DifferenceByCause result = difference_by_cause(request, control);
  if (arguments.json) {
    print_json(arguments, result, provenance_json(document_provenance(document, Side::a)));
    return 0;
  }
  fmt::print("{} between A and B: {:.4g} ({} pictures, {})\n", result.metric, result.total, result.renders,
             result.every_order ? "mean over all orders"
                                : fmt::format("mean over {} orders, seed {}", 2 * arguments.orders, arguments.seed));
  fmt::print("{:<40} {:>10} {:>8} {:>10} {:>10}\n", "option", "share", "", "alone", "without");
  for (const CauseShare& cause : result.causes) {
    const std::string change = fmt::format("{}: {} -> {}", cause.option, cause.from, cause.to);
    if (!cause.note.empty())
      fmt::print("{:<40} {}\n", change, cause.note);
    else
      fmt::print("{:<40} {:>10.4g} {:>7.1f}% {:>10.4g} {:>10.4g}\n", change, cause.share,
                 result.total != 0 ? 100 * cause.share / result.total : 0, cause.alone, cause.without);
  }
  return 0;
}

}  // namespace

void add_causes_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("causes", "how much of the difference between A and B each option causes");
  const auto arguments = std::make_shared<CausesArguments>();
  add_scene_arguments(*command, arguments->scene);
  command->add_option("--set-b", arguments->settings_b, "set an option of B; all others are those of A")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false)
      ->required();
  command->add_option("--metric", arguments->metric, "mae, rmse, max, ssim or flip");
  command
      ->add_option("--orders", arguments->orders,
                   "number of random orders, each also used backwards, for seven options or more")
      ->check(whole_number_from(1, 10000));
  command->add_option("--seed", arguments->seed, "seed of the random orders")
      ->check(whole_number_from(0, std::numeric_limits<std::uint32_t>::max()));
  command->add_flag("--json", arguments->json, "as JSON");
  command->callback([&chosen, arguments] { chosen = [arguments] { return run_causes(*arguments); }; });
}

}  // namespace ps::cli
