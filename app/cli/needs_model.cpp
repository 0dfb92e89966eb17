#include "cli/needs_model.h"

#include <fmt/format.h>

#include <unistd.h>

#include <nlohmann/json.hpp>

#include "base/check.h"
#include "base/enumerators.h"
#include "base/extension.h"
#include "base/kept_inputs.h"
#include "base/number_text.h"
#include "base/read_file.h"
#include "cli/interrupt.h"
#include "cli/needs_head.h"
#include "cli/output_file.h"
#include "image/file.h"
#include "options/scene_settings.h"
#include "render/provenance.h"
#include "scene/load.h"
#include "study/model/model_files.h"
#include "study/model/model_words.h"
#include "study/model/views.h"
#include "study/needs_words.h"

namespace ps::cli {
namespace {

constexpr std::string_view orbit_start = "orbit:";
constexpr int most_views = 64;

std::vector<View> asked_views(const std::string& text, const Document& document, StudyControl& control) {
  const View view = view_of(document);
  if (text.empty()) return {view};
  if (!text.starts_with(orbit_start)) return parse_views(read_whole_file(text), text, view);
  const auto count = parse_integer<int>(std::string_view(text).substr(orbit_start.size()));
  if (!count || *count < 1 || *count > most_views)
    throw InputError(
        fmt::format("--views: found '{}', expected orbit:N with N from 1 to {}, or a file", text, most_views));
  return orbit_views(document.scene, view, *count, control);
}

/// The saved scene, read and drawn again.
struct Checked {
  std::string file;
  model::Change change;
  bool holds = false;
};

Checked save_and_check(const ModelRequest& request, const ModelNeeds& needs, const std::string& file,
                       StudyControl& control) {
  save_reduced(needs, request.views.front(), file);
  const Scene saved = load_scene(file);
  Checked checked{file, check_reduction(request, saved, settings_for(saved), control), false};
  checked.holds = checked.change.increase <= request.tolerance;
  return checked;
}

std::string share(double part) { return fmt::format("{:.1f} %", 100 * part); }

void print_json(const Document& document, const ModelRequest& request, const ModelNeeds& needs,
                const std::optional<Checked>& checked) {
  nlohmann::ordered_json json = needs_head(document, model_sentence(needs), needs.tolerance);
  json.update({{"views", needs.views},
               {"settings", changed_settings(request.base, needs.settings)},
               {"work", needs.work},
               {"default_work", needs.default_work},
               {"bytes", needs.bytes},
               {"default_bytes", needs.default_bytes},
               {"increase", needs.change.increase},
               {"rmse", needs.change.rmse}});
  json["savings"] = nlohmann::ordered_json::array();
  for (const ModelSaving* saving : greatest_first(needs)) {
    nlohmann::ordered_json row{{"part", enumerator_key(saving->part)}, {"goes", saving->goes},
                               {"work_share", saving->work},           {"byte_share", saving->bytes},
                               {"increase", saving->change.increase},  {"rmse", saving->change.rmse}};
    row["items"] = nlohmann::ordered_json::array();
    for (const ModelThing& thing : saving->things) {
      nlohmann::ordered_json one{{"name", thing.name}, {"bytes", thing.bytes}};
      if (thing.picture) one["picture_share"] = *thing.picture;
      if (thing.work) one["work_share"] = *thing.work;
      if (thing.increase > 0) one["increase"] = thing.increase;
      row["items"].push_back(std::move(one));
    }
    json["savings"].push_back(std::move(row));
  }
  json["remarks"] = needs.remarks;
  if (checked)
    json["checked"] = {{"file", checked->file},
                       {"increase", checked->change.increase},
                       {"rmse", checked->change.rmse},
                       {"holds", checked->holds}};
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

void print_text(const Document& document, const ModelRequest& request, const ModelNeeds& needs,
                const std::optional<Checked>& checked) {
  constexpr std::size_t most_things = 8;
  fmt::print("{}\n", model_sentence(needs));
  fmt::print("This holds {} of {} x {} pixels, by rays and by fragments.\n", views_words(needs.views),
             request.views.front().width, request.views.front().height);
  if (!needs.savings.empty())
    fmt::print("\n{:>8} {:>8} {:>8} {:>11}  {}\n", "picture", "work", "bytes", "error added", "what can go");
  for (const ModelSaving* saving : greatest_first(needs)) {
    fmt::print("{:>8} {:>8} {:>8} {:>11.2g}  {}\n", "", share(saving->work), share(saving->bytes),
               saving->change.increase, saving->goes);
    for (std::size_t i = 0; i < std::min(saving->things.size(), most_things); ++i) {
      const ModelThing& thing = saving->things[i];
      const double bytes =
          static_cast<double>(thing.bytes) / static_cast<double>(std::max<std::uint64_t>(1, needs.default_bytes));
      fmt::print("{:>8} {:>8} {:>8} {:>11}    {}\n", thing.picture ? share(*thing.picture) : "",
                 thing.work ? share(*thing.work) : "", thing.bytes > 0 ? share(bytes) : "",
                 thing.increase > 0 ? fmt::format("{:.2g}", thing.increase) : "", thing.name);
    }
    if (saving->things.size() > most_things)
      fmt::print("{:>40}  and {} more\n", "", saving->things.size() - most_things);
  }
  fmt::print("\n");
  for (const std::string& remark : needs.remarks) fmt::print("{}\n", remark);
  fmt::print("error      {:.2g} added of {:.2g} allowed, which is {} (largest mean FLIP of a tile)\n",
             needs.change.increase, needs.tolerance, tolerance_words(needs.tolerance));
  fmt::print("work       {} rays, tests, fragments and texels, now {} (pictures of a quarter of the sides)\n",
             needs.work, needs.default_work);
  fmt::print("bytes      {}, now {}\n", with_thousands(std::to_string(needs.bytes)),
             with_thousands(std::to_string(needs.default_bytes)));
  const std::string settings = changed_settings(request.base, needs.settings);
  if (!settings.empty()) fmt::print("settings   {}\n", settings);
  if (checked)
    fmt::print("saved      {}: drawn afresh, it adds {:.2g}{}\n", checked->file, checked->change.increase,
               checked->holds ? "" : ", which is more than is allowed");
  print_made_by(document);
}

}  // namespace

int run_model_needs(const Document& document, const ModelArguments& arguments) {
  if (!arguments.save.empty()) {
    require_output_file(arguments.save, OutputKind::any);
    if (lower_extension(arguments.save) != ".scene")
      throw InputError(fmt::format("--save: found '{}', expected a .scene file", arguments.save));
    require_no_input(arguments.save, files_of(document.scene));
  }
  if (!arguments.sheet.empty()) {
    require_output_file(arguments.sheet, OutputKind::levels);
    require_no_input(arguments.sheet, files_of(document.scene));
  }
  StudyControl control;
  forward_interrupts(control.progress());
  ModelRequest request;
  request.scene = document.scene;
  request.views = asked_views(arguments.views, document, control);
  request.base = document.a.settings;
  request.tolerance = arguments.tolerance;
  const bool shown = isatty(STDERR_FILENO) != 0;
  const ModelNeeds needs = find_model_needs(request, control, [&](const StudyStatus& status) {
    if (shown) fmt::print(stderr, "\r{} of {} parts weighed   ", status.done, status.total);
  });
  if (shown) fmt::print(stderr, "\n");
  if (!arguments.sheet.empty())
    save_image(arguments.sheet, before_and_after(request, needs, control), {image_texts(provenance_of(request.base))});
  std::optional<Checked> checked;
  if (!arguments.save.empty()) checked = save_and_check(request, needs, arguments.save, control);
  if (arguments.json)
    print_json(document, request, needs, checked);
  else
    print_text(document, request, needs, checked);
  return checked && !checked->holds ? 1 : 0;
}

}  // namespace ps::cli
