#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/check.h"
#include "base/kept_inputs.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/output_file.h"
#include "cli/scene_arguments.h"
#include "document/permalink.h"
#include "engine/screen_names.h"
#include "frame/left_out.h"
#include "image/file.h"
#include "number_option.h"
#include "options/renderer_kind.h"
#include "options/scene_settings.h"
#include "render/provenance.h"
#include "scene/load.h"
#include "study/chart.h"
#include "study/chart_style.h"
#include "study/picture_sheet.h"
#include "study/renderer_sweep.h"

namespace ps::cli {
namespace {

/// Those that CGPP draws with its ray caster, its rasterizer and the graphics processor (15.3.4, 15.4.8, 15.4.9).
const std::vector<std::string> book_scenes{"cgpp/triangle", "cgpp/ground", "cgpp/teapot"};

struct RenderersArguments {
  std::vector<std::string> scenes = book_scenes, settings;
  std::string size = "400x250", sheet;
  int repeats = 5;
};

/// Triangles have no traced shadows. Where the scene asks for some, they come from maps, as CGPP 15.7 has them.
void take_shadow_maps(const SceneTraits& traits, SweepPoint& point) {
  if (!draws_fragments(point.value.renderer) || point.value.shadows != Shadows::traced) return;
  if (!asks_for_shadows(traits, point.value)) return;
  point.value.shadows = Shadows::map;
  point.settings += ";shadows=map";
}

ChartRequest request_for(const std::string& scene, const RenderersArguments& arguments) {
  SceneArguments one;
  one.scene = scene;
  one.size = arguments.size;
  one.settings = arguments.settings;
  const Document document = load_document(one);
  const std::vector<SweepAxis> axes = parse_sweep(renderer_sweep);
  ChartRequest request;
  request.scene = document.scene;
  request.scene.name = document.scene_name;
  request.view = view_of(document);
  request.base = document.a.settings;
  request.points = sweep_points(axes, request.base, settings_for(document.base), scene_traits(request.scene));
  for (SweepPoint& point : request.points) take_shadow_maps(scene_traits(request.scene), point);
  request.absent = absent_renderers(axes);
  request.repeats = arguments.repeats;
  return request;
}

void print_points(const Chart& chart) {
  for (const ChartPoint& point : chart.points) {
    const Settings& settings = point.what.value;
    std::string notes = settings.shadows == Shadows::map ? "shadow map" : "";
    for (const std::string& left : brief_texts(point.left_out)) notes += (notes.empty() ? "" : ", ") + left;
    const std::string upload = point.upload_ms ? fmt::format("{:.3g}", point.upload_ms->median) : "-";
    fmt::print("{:<16} {:<18} {:>8.3g} {:>9} {:>8.3g}  {}\n", chart.identity.scene,
               renderer_kind(settings.renderer).label, point.time_ms.median, upload, point.error, notes);
  }
}

/// A window that begins with the first renderer in A and the last in B; its chart sweeps them all, and a click on a
/// point there puts that renderer into A.
std::string window_link(const std::string& scene, const Chart& chart, const RenderersArguments& arguments) {
  SceneArguments one;
  one.scene = scene;
  one.settings = arguments.settings;
  Document document = load_document(one);
  document.a.settings = chart.points.front().what.value;
  document.b.settings = chart.points.back().what.value;
  document.mode = ScreenMode::study;
  document.layout.bottom_tab = tool_names::chart;
  return permalink(document);
}

int run_renderers(const RenderersArguments& arguments) {
  if (!arguments.sheet.empty()) require_output_file(arguments.sheet, OutputKind::levels);
  std::vector<ChartRequest> requests;  // all of them first: a bad one is refused before anything is drawn
  for (const std::string& scene : arguments.scenes) requests.push_back(request_for(scene, arguments));
  for (const ChartRequest& request : requests)
    if (!arguments.sheet.empty()) require_no_input(arguments.sheet, files_of(request.scene));
  StudyControl control;
  forward_interrupts(control.progress());
  std::vector<std::vector<Image<Rgb8>>> pictures;
  std::vector<std::string> links, provenance;
  fmt::print("{:<16} {:<18} {:>8} {:>9} {:>8}\n", "scene", "renderer", "time ms", "upload ms", "rmse");
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const Chart chart = run_chart(requests[i], control);
    print_points(chart);
    pictures.emplace_back();
    for (const ChartPoint& point : chart.points) pictures.back().push_back(*point.picture);
    links.push_back(window_link(arguments.scenes[i], chart, arguments));
    provenance.push_back(fmt::format("{}: {}", chart.identity.scene, chart_provenance(chart)));
  }
  for (const std::string& line : provenance) fmt::print("{}\n", line);
  for (const std::string& link : links) fmt::print("pixelscope --permalink '{}'\n", link);
  if (!arguments.sheet.empty())
    save_image(arguments.sheet, picture_sheet(pictures), {image_texts(provenance_of(requests.front().base))});
  return 0;
}

}  // namespace

void add_renderers_command(CLI::App& app, Action& chosen) {
  CLI::App* command =
      app.add_subcommand("renderers", "draw scenes with every renderer side by side, and measure time and error");
  const auto arguments = std::make_shared<RenderersArguments>();
  command->add_option("SCENE", arguments->scenes,
                      "files or built-in names; default: CGPP's triangle, triangle with ground, and teapot");
  command->add_option("--size", arguments->size, "of each picture; default: 400x250")->type_name("WxH");
  command->add_option("--set", arguments->settings, "an option, for all scenes")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->add_option("--repeats", arguments->repeats, "number of timed runs of each picture")
      ->check(whole_number_from(1, 1000));
  command->add_option("--sheet", arguments->sheet,
                      "write a .png or .ppm file: a row for each scene, a column for each renderer");
  command->callback([&chosen, arguments] { chosen = [arguments] { return run_renderers(*arguments); }; });
}

}  // namespace ps::cli
