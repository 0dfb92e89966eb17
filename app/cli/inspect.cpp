#include <fmt/format.h>

#include <limits>
#include <memory>

#include "base/kept_inputs.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/output_file.h"
#include "cli/print_listing.h"
#include "cli/print_rows.h"
#include "cli/print_vertex.h"
#include "cli/scene_arguments.h"
#include "document/document_provenance.h"
#include "document/number_list.h"
#include "inspect/describe.h"
#include "inspect/microscope/micro_svg.h"
#include "inspect/space_drawing.h"
#include "inspect/space_orbit.h"
#include "inspect/story_json.h"
#include "inspect/story_markdown.h"
#include "math/conventions.h"
#include "number_option.h"
#include "options/renderer_kind.h"
#include "record/value_text.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::cli {
namespace {

struct InspectArguments {
  SceneArguments scene;
  std::string pixel;
  int instance = -1;
  VertexArguments vertex;
  bool rows = false;
  bool json = false, markdown = false, csv = false;
  std::string svg;    ///< "space" or "microscope"; empty = none
  std::string point;  ///< of the microscope; empty = the pixel's first sample
  std::string out;    ///< file; empty = standard output
};

int depth_of(const PixelStory& story, std::size_t index) {
  int depth = 0;
  for (int above = story.events[index].parent; above >= 0; above = story.events[static_cast<std::size_t>(above)].parent)
    ++depth;
  return depth;
}

void print_story(const PixelStory& story, const Scene& scene, const View& view) {
  const Vec2i book = book_pixel(story.pixel.x, story.pixel.y, view.width, view.height);
  fmt::print("pixel ({}, {}), in the book's coordinates ({}, {})\n", story.pixel.x, story.pixel.y, book.x, book.y);
  fmt::print("{}\n", story.verdict);
  fmt::print("linear {}, stored as {}, {}, {}\n\n", vector_text(story.linear), story.display[0], story.display[1],
             story.display[2]);
  for (std::size_t i = 0; i < story.events.size(); ++i)
    fmt::print("{:{}}{}\n", "", 2 * depth_of(story, i), describe(story.events[i], scene));
  if (story.triangles_elsewhere > 0)
    fmt::print("{} triangles lie elsewhere in the picture\n", story.triangles_elsewhere);
  if (!story.not_reported.empty()) fmt::print("{}\n", story.not_reported);
  fmt::print("\n");
  for (const LedgerLine& line : story.ledger)
    fmt::print("{:<32}{:{}}{}\n", line.value == Vec3d{0, 0, 0} ? "" : vector_text(line.value), "", 2 * line.level,
               line.term);
}

constexpr Vec2i drawing_size{1200, 800};
constexpr double near_share = 0.02;  // of the viewer's distance

/// The space view from its standard place.
std::string draw_space(const Document& document, const View& view, const PixelStory& story, Prepared& prepared) {
  const Scene& scene = document.scene;
  const SpaceModel model = build_space(scene, view, document.a.settings, &story);
  const double aspect = static_cast<double>(drawing_size.x) / drawing_size.y;
  const SpaceOrbit orbit = preset_orbit(SpacePreset::outside, model.bounds, scene.camera, aspect);
  const View viewer = orbit_view(orbit, scene.camera, drawing_size.x, drawing_size.y);
  return space_svg(model,
                   draw_space_picture(scene, viewer, near_share * orbit.distance, prepared, interruptible_progress()));
}

std::string draw_microscope(const Document& document, const View& view, Vec2i pixel, const std::string& point,
                            Prepared& prepared) {
  if (runs_listing(document.a.settings.renderer))
    throw InputError(
        fmt::format("--svg microscope: found renderer={}, expected a renderer that samples pixels: {} or {}",
                    renderer_kind(document.a.settings.renderer).key, renderer_kind(renderer_for(PictureWay::rays)).key,
                    renderer_kind(renderer_for(PictureWay::fragments)).key));
  const Microscope microscope(document.scene, view, document.a.settings, pixel, prepared, interruptible_progress());
  Vec2d at = microscope.samples().front().position;
  if (!point.empty()) {
    const auto numbers = parse_number_list(point, 2, "point");
    at = {numbers[0], numbers[1]};
    for (int axis = 0; axis < 2; ++axis)
      if (!(at[axis] >= -micro_margin && at[axis] <= 1 + micro_margin))
        throw InputError(
            fmt::format("point: found {}, expected two numbers from {} to {}", point, -micro_margin, 1 + micro_margin));
  }
  return micro_svg(microscope, microscope.read(at, prepared, interruptible_progress()));
}

/// The pixel that was asked for, else that of the permalink.
Vec2i picked_pixel(const Document& document, const InspectArguments& arguments, const std::optional<Vec2i>& asked) {
  if (asked) return *asked;
  if (arguments.scene.permalink.empty()) throw InputError("--pixel is required");
  if (document.pixel.x < 0) throw InputError("--pixel is required: the permalink has no picked pixel");
  return document.pixel;
}

int run_inspect(const InspectArguments& arguments) {
  std::optional<Vec2i> asked;
  if (!arguments.pixel.empty()) asked = parse_pixel_text(arguments.pixel);
  if (!arguments.svg.empty() && arguments.svg != "space" && arguments.svg != "microscope")
    throw InputError(fmt::format("svg: found '{}', expected space or microscope", arguments.svg));
  if (!arguments.out.empty() && !arguments.vertex.vertex.empty())
    throw InputError("--out: cannot be combined with --vertex, which prints its result");
  if (!arguments.out.empty()) require_output_file(arguments.out, OutputKind::any);
  Document document = load_document(arguments.scene);
  const Vec2i pixel = picked_pixel(document, arguments, asked);
  document.pixel = pixel;
  require_no_input(arguments.out, files_of(document.scene));
  const View view = view_of(document);
  if (pixel.x >= view.width || pixel.y >= view.height)
    throw InputError(fmt::format("pixel: found {},{}, expected one inside the picture of {} x {}", pixel.x, pixel.y,
                                 view.width, view.height));
  if (arguments.rows) {
    write_result(rows_text(document, pixel, arguments.json), arguments.out);
    return 0;
  }
  Prepared prepared;
  const PixelStory story =
      inspect(document.scene, view, document.a.settings, pixel, prepared, interruptible_progress());
  if (!arguments.vertex.vertex.empty()) {
    print_vertex(document, story, arguments.vertex, arguments.json);
    return 0;
  }
  const Provenance made = document_provenance(document, Side::a);
  if (arguments.svg == "space")
    write_result(svg_with_provenance(draw_space(document, view, story, prepared), made), arguments.out);
  else if (arguments.svg == "microscope")
    write_result(svg_with_provenance(draw_microscope(document, view, pixel, arguments.point, prepared), made),
                 arguments.out);
  else if (arguments.json)
    write_result(story_json(story, document.scene, view, made) + "\n", arguments.out);
  else if (arguments.csv)
    write_result(story_csv(story, document.scene, made), arguments.out);
  else if (arguments.markdown || !arguments.out.empty())
    write_result(story_markdown(story, document.scene, view, made), arguments.out);
  else
    print_story(story, document.scene, view);
  const bool as_text = !arguments.json && !arguments.csv && !arguments.markdown && arguments.svg.empty();
  if (story.listing && as_text && arguments.out.empty()) {
    fmt::print("\n");
    print_listing(*story.listing, arguments.instance);
  }
  return 0;
}

}  // namespace

void add_inspect_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("inspect", "show how one pixel got its colour");
  const auto arguments = std::make_shared<InspectArguments>();
  add_scene_arguments(*command, arguments->scene);
  command
      ->add_option("--pixel", arguments->pixel,
                   "column and row from the top left, from 0; default: the pixel of the permalink")
      ->type_name("X,Y")
      ->delimiter('\0');
  command
      ->add_option("--instance", arguments->instance,
                   "of a textbook listing: the loop iteration whose values are shown")
      ->type_name("N")
      ->check(whole_number_from(0, std::numeric_limits<int>::max()));
  command
      ->add_option(
          "--vertex", arguments->vertex.vertex,
          "follow a vertex from its model to the canvas instead: the vertex nearest to the pixel, or by its index")
      ->type_name("nearest|OBJECT,INDEX")
      ->delimiter('\0');
  command
      ->add_option("--vertex-order", arguments->vertex.order,
                   "order of rotation and translation: turn-then-move or move-then-turn")
      ->type_name("ORDER");
  command->add_option("--vertex-near", arguments->vertex.near, "clip at another near plane")
      ->type_name("D")
      ->check(number_above(0));
  const auto rows = command->add_flag("--rows", arguments->rows,
                                      "print the rows of the canvas shapes at the pixel instead: left, between the "
                                      "pixels of interpolated edges (LAB 4); right, by the fill rule");
  const auto json = command->add_flag("--json", arguments->json, "as JSON, with all digits");
  const auto markdown = command->add_flag("--markdown", arguments->markdown, "as a page of Markdown")->excludes(json);
  const auto csv = command->add_flag("--csv", arguments->csv, "as comma-separated values, one line for each number")
                       ->excludes(json)
                       ->excludes(markdown);
  command->add_option("--svg", arguments->svg, "as an SVG drawing: the scene from outside, or the pixel at panel size")
      ->type_name("space|microscope")
      ->excludes(json)
      ->excludes(markdown)
      ->excludes(csv)
      ->excludes(rows);
  rows->excludes(markdown)->excludes(csv);
  command->add_option("--point", arguments->point, "sample point of the microscope, in pixels from the pixel's corner")
      ->type_name("X,Y")
      ->delimiter('\0');
  command->add_option("--out", arguments->out, "write to this file (as Markdown by default)");
  command->callback([&chosen, arguments] { chosen = [arguments] { return run_inspect(*arguments); }; });
}

}  // namespace ps::cli
