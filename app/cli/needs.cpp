#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/needs_head.h"
#include "cli/needs_model.h"
#include "cli/scene_arguments.h"
#include "number_option.h"
#include "options/scene_settings.h"
#include "study/needs.h"
#include "study/needs_words.h"

namespace ps::cli {
namespace {

struct NeedsArguments {
  SceneArguments scene;
  double tolerance = NeedsRequest{}.tolerance;
  int repeats = NeedsRequest{}.repeats;
  bool json = false, model = false;
  std::string views, sheet, save;
};

void print_json(const Document& document, const Needs& needs) {
  nlohmann::ordered_json json = needs_head(document, needs_sentence(document.scene_name, needs), needs.tolerance);
  json.update({{"within-tolerance", needs.within_tolerance},
               {"settings", changed_settings(settings_for(document.base), needs.advice)},
               {"error", needs.error},
               {"default_error", needs.default_error},
               {"time_ms", needs.time_ms},
               {"default_time_ms", needs.default_time_ms},
               {"work", needs.work},
               {"default_work", needs.default_work},
               {"machinery", needs.machinery},
               {"truth", needs.truth},
               {"uncertainty", needs.uncertainty},
               {"increase", needs.increase}});
  json["meshes"] = {{"triangles", needs.meshes.triangles},
                    {"vertices", needs.meshes.vertices},
                    {"shared_bytes", needs.meshes.shared},
                    {"unshared_bytes", needs.meshes.unshared}};
  json["features"] = nlohmann::ordered_json::array();
  for (const FeatureShare& share : needs.shares) {
    nlohmann::ordered_json feature{{"name", share.feature.name},           {"used", share.used},
                                   {"error_without", share.error_without}, {"cost_share", share.cost_share},
                                   {"work_share", share.work_share},       {"increase", share.increase}};
    if (!share.used) feature["reason"] = text_of(share.reason);
    json["features"].push_back(std::move(feature));
  }
  json["trail"] = nlohmann::ordered_json::array();
  for (const NeedsStep& step : needs.trail)
    json["trail"].push_back({{"change", step.change},
                             {"error", step.error},
                             {"work", step.work},
                             {"accepted", step.accepted},
                             {"increase", step.increase}});
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

void print_text(const Document& document, const Needs& needs) {
  fmt::print("{}\n{}\n\n", needs_sentence(document.scene_name, needs), truth_sentence(needs));
  fmt::print("{:<30} {:>14} {:>11} {:>11}\n", "without", "error added", "time share", "work share");
  for (const FeatureShare& share : needs.shares)
    if (share.used)
      fmt::print("{:<30} {:>14.4g} {:>11} {:>10.1f}%\n", share.feature.label, share.increase,
                 share.cost_differs ? fmt::format("{:.1f}%", 100 * share.cost_share) : "noise", 100 * share.work_share);
  if (const std::string unused = unused_sentence(needs.shares); !unused.empty()) fmt::print("{}\n", unused);
  fmt::print("\n{:<30} {:>14} {:>23}\n", "tried", "error added", "work");
  for (const NeedsStep& step : needs.trail)
    fmt::print("{:<30} {:>14.4g} {:>23}{}\n", step.change, step.increase, step.work, step.accepted ? "  taken" : "");
  fmt::print("\n");
  const std::string advice = changed_settings(settings_for(document.base), needs.advice);
  const bool keep = needs.advice == document.a.settings;
  fmt::print("advice     {}\n", keep ? keep_sentence() : advice);
  if (!needs.within_tolerance) fmt::print("           {}\n", not_enough_sentence(needs));
  fmt::print("error      {:.4g} added of {:.4g} allowed, which is {} (largest mean FLIP of a tile)\n", needs.increase,
             needs.tolerance, tolerance_words(needs.tolerance));
  fmt::print("time       {:.4g} ms, now {:.4g} ms{} ({})\n", needs.time_ms, needs.default_time_ms,
             needs.time_differs ? "" : ": the same within noise", needs.machinery);
  fmt::print("work       {} rays, tests, fragments and texels, now {}\n", needs.work, needs.default_work);
  if (const std::string meshes = mesh_bytes_text(needs.meshes); !meshes.empty()) fmt::print("meshes     {}\n", meshes);
  print_made_by(document);
}

int run_needs(const NeedsArguments& arguments) {
  if (!arguments.model && !(arguments.views.empty() && arguments.sheet.empty() && arguments.save.empty()))
    throw InputError("--views, --sheet and --save: they need --model");
  const Document document = load_document(arguments.scene);
  if (arguments.model)
    return run_model_needs(document,
                           {arguments.tolerance, arguments.views, arguments.sheet, arguments.save, arguments.json});
  NeedsRequest request;
  request.scene = document.scene;
  request.view = view_of(document);
  request.base = document.a.settings;
  request.tolerance = arguments.tolerance;
  request.repeats = arguments.repeats;
  StudyControl control;
  forward_interrupts(control.progress());
  const Needs needs = find_needs(request, control);
  if (arguments.json)
    print_json(document, needs);
  else
    print_text(document, needs);
  return 0;
}

}  // namespace

void add_needs_command(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("needs", "find what a scene needs: features, cheapest settings, and what of the model can go");
  const auto arguments = std::make_shared<NeedsArguments>();
  add_scene_arguments(*command, arguments->scene);
  command
      ->add_option("--tolerance", arguments->tolerance, "largest allowed mean FLIP of any tile of about 16 x 16 pixels")
      ->check(number_from(0, 1));
  command->add_option("--repeats", arguments->repeats, "number of timed runs of each variant")
      ->check(whole_number_from(1, 1000));
  command->add_flag("--model", arguments->model,
                    "what of the model can go: objects, triangles, texels, lights, bounces, bits");
  command
      ->add_option("--views", arguments->views,
                   "with --model: views that the reduced scene must hold for, N of them around what is seen, or a file "
                   "with a camera on each line; default: the scene's own")
      ->type_name("orbit:N|FILE");
  command
      ->add_option("--sheet", arguments->sheet,
                   "with --model: one picture of full and reduced scene side by side with their difference")
      ->type_name("FILE.png");
  command->add_option("--save", arguments->save, "with --model: write the reduced scene, read it again and check it")
      ->type_name("FILE.scene");
  command->add_flag("--json", arguments->json, "as JSON");
  command->callback([&chosen, arguments] { chosen = [arguments] { return run_needs(*arguments); }; });
}

}  // namespace ps::cli
