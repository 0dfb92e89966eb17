#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/atomic_file.h"
#include "base/extension.h"
#include "base/kept_inputs.h"
#include "base/progress_line.h"
#include "base/timer.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/output_file.h"
#include "cli/scene_arguments.h"
#include "document/document_provenance.h"
#include "document/permalink.h"
#include "frame/display_frame.h"
#include "image/file.h"
#include "inspect/vertex_chain.h"
#include "number_option.h"
#include "options/option.h"
#include "raster/clear/coverage/efficiency.h"
#include "render/channel_picture.h"
#include "render/left_out.h"
#include "render/render.h"
#include "render/slow_motion.h"
#include "scene/load.h"
#include "scene/mesh_bytes.h"

namespace ps::cli {
namespace {

struct RenderArguments {
  SceneArguments scene;
  std::string output;
  std::string show;         ///< key of a channel; empty = that of the permalink, or the colours
  std::string field, mark;  ///< a number of the story to show, and the condition that marks pixels; may be empty
  std::string stats;
  bool mark_vertices = false;
  std::string ppm;          ///< "ascii" or "binary"; empty = binary
  std::vector<int> region;  ///< x, y, width, height; empty = all
  std::string slow_motion;  ///< "UNIT:N"; empty = that of the permalink, or the whole picture
  std::string film;         ///< a folder for the pictures on the way to N; empty = none
  int film_pictures = 24;
};

/// The pixels that --region asks for, which must lie in the picture at least in part.
std::optional<TileRect> region_of(const std::vector<int>& numbers, const View& view) {
  if (numbers.empty()) return {};
  const int x = numbers[0], y = numbers[1], width = numbers[2], height = numbers[3];
  const bool inside = x < view.width && y < view.height && width > 0 && height > 0 && std::int64_t{x} + width > 0 &&
                      std::int64_t{y} + height > 0;
  if (!inside)
    throw InputError(fmt::format("--region: found {},{},{},{}, expected X,Y,W,H with W and H above 0, inside {}x{}", x,
                                 y, width, height, view.width, view.height));
  const auto end = [](int from, int size, int limit) {
    return static_cast<int>(std::min<std::int64_t>(std::int64_t{from} + size, limit));
  };
  return TileRect{std::max(x, 0), std::max(y, 0), end(x, width, view.width), end(y, height, view.height)};
}

/// Everything about a finished picture except its pixels.
std::string stats_json(const Document& document, const View& view, const Frame& frame, double milliseconds) {
  const Settings& settings = document.a.settings;
  const Provenance made = provenance_of(settings, frame.path.machinery);
  nlohmann::ordered_json json{{"program", made.program},
                              {"scene", document.scene_name},
                              {"size", {view.width, view.height}},
                              {"permalink", permalink(document)},
                              {"processor", made.processor},
                              {"threads", made.threads},
                              {"simd", made.simd}};
  for (const Option& option : option_table()) json["settings"][std::string(option.key)] = option_text(option, settings);
  for (std::size_t i = 0; i < counter_count; ++i) {
    const auto counter = static_cast<Counter>(i);
    auto& value = json["counters"][std::string(counter_key(counter))];  // null: the renderer cannot give it
    if (const auto count = frame.counters.get(counter)) value = *count;
  }
  const MeshBytes meshes = bytes_of_meshes(document.scene);
  json["mesh_bytes"] = {{"shared", meshes.shared}, {"unshared", meshes.unshared}};
  if (const auto efficiency = raster::sample_test_efficiency(frame.counters))
    json["sample_test_efficiency"] = *efficiency;
  json["machinery"] = {{"path", machinery_key(frame.path.machinery)},
                       {"shading", shading_key(frame.path.shading)},
                       {"reason", frame.path.reason}};
  json["left_out"] = nlohmann::ordered_json::array();
  for (const LeftOut& one : left_out(scene_traits(document.scene), settings)) json["left_out"].push_back(one.sentence);
  json["time_ms"] = milliseconds;
  json["stages"] = nlohmann::ordered_json::array();
  for (const StageTime& time : frame.times)
    json["stages"].push_back({{"stage", time.stage}, {"time_ms", time.milliseconds}});
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

/// Sets the pixels to which the vertices of models are projected, in a colour of no scene (CGPP 15.6.2).
void mark_vertices(const Document& document, const View& view, Image<Rgb8>& levels) {
  constexpr Rgb8 mark{255, 0, 255};
  constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
  for (const ProjectedVertex& vertex : projected_vertices(document.scene, view, document.a.settings, all))
    levels.at(static_cast<int>(vertex.canvas.x), static_cast<int>(vertex.canvas.y)) = mark;
}

/// `levels`: of the whole picture's colours, or empty.
void save_picture(const RenderArguments& arguments, const Document& document, const Frame& frame,
                  const Image<Rgb8>& levels) {
  const Settings& settings = document.a.settings;
  const ShownChannel show = document.a.show;
  if (lower_extension(arguments.output) == ".pfm") {
    std::visit([&](const auto& floats) { save_pfm(arguments.output, floats); }, channel_floats(frame, show));
    return;
  }
  SaveOptions options;
  options.pnm = arguments.ppm == "ascii" ? PnmForm::ascii : PnmForm::binary;
  options.texts = image_texts(document_provenance(document, Side::a, frame.path.machinery, arguments.output));
  if (show == ShownChannel::colour)
    save_image(arguments.output, levels.empty() ? display_frame(frame, settings) : levels, options);
  else
    save_image(arguments.output, channel_picture(frame, show, settings).levels, options);
}

/// The picture as far as slow motion goes; says how far that is.
Frame render_document(const Document& document, const View& view, const RenderRequest& request, Prepared& prepared) {
  const SideState& side = document.a;
  std::optional<ProgressLine> line(std::in_place, interruptible_progress(), "rendering");
  if (!side.slow_motion)
    return render(document.scene, view, side.settings, request, prepared, interruptible_progress());
  SlowFrame slow = render_slowly(document.scene, view, side.settings, *side.slow_motion, request, prepared,
                                 interruptible_progress());
  line.reset();
  fmt::print(stderr, "{}\n", slow_motion_words(slow.state, document.scene, {view.width, view.height}));
  return slow.frame;
}

/// Writes the states on the way to the one that was asked for, evenly spread, as 0001.png and so on.
void save_film(const RenderArguments& arguments, Document document, const View& view, const RenderRequest& request,
               Prepared& prepared) {
  const SlowMotion last = *document.a.slow_motion;
  const ProgressLine line(interruptible_progress(), "rendering the film");
  const std::uint64_t end =
      render_slowly(document.scene, view, document.a.settings, last, request, prepared, interruptible_progress())
          .state.done.at;
  RenderArguments one = arguments;
  const auto count = static_cast<std::uint64_t>(arguments.film_pictures);
  for (std::uint64_t i = 1; i <= count; ++i) {
    document.a.slow_motion = SlowMotion{last.unit, end * i / count};
    one.output = (std::filesystem::path(arguments.film) / fmt::format("{:04}.png", i)).string();
    const SlowFrame slow = render_slowly(document.scene, view, document.a.settings, *document.a.slow_motion, request,
                                         prepared, interruptible_progress());
    save_picture(one, document, slow.frame, {});
  }
}

int run_render(const RenderArguments& arguments) {
  require_output_file(arguments.output, OutputKind::picture);
  if (!arguments.ppm.empty() && lower_extension(arguments.output) != ".ppm")
    throw InputError(fmt::format("--ppm: the output is {}, expected a .ppm file", arguments.output));
  if (!arguments.stats.empty()) {
    require_output_file(arguments.stats, OutputKind::any);
    std::error_code error;
    if (std::filesystem::weakly_canonical(arguments.stats, error) ==
        std::filesystem::weakly_canonical(arguments.output, error))
      throw InputError(fmt::format("--stats: {} is the picture's own file", arguments.stats));
  }
  Document document = load_document(arguments.scene);
  if (!arguments.field.empty()) document.field = ShownField{parse_field_query(arguments.field), {}};
  if (!arguments.mark.empty()) {
    if (!document.field) throw InputError("--mark: needs --field");
    document.field->condition = parse_field_condition(arguments.mark);
  }
  const ShownChannel asked = arguments.field.empty() ? document.a.show : ShownChannel::field;
  const ShownChannel show = arguments.show.empty() ? asked : parse_shown_channel(arguments.show);
  if (show == ShownChannel::field && !document.field) throw InputError("--show field: needs --field");
  if (show == ShownChannel::field)
    if (const auto reason = no_field_reason(document.a.settings.renderer, document.field->query); !reason.empty())
      throw InputError(fmt::format("--field: {}", reason));
  for (const std::string& file : {arguments.output, arguments.stats}) require_no_input(file, files_of(document.scene));
  document.a.show = show;
  const View view = view_of(document);
  if (!arguments.region.empty()) document.view.region = region_of(arguments.region, view);
  if (!arguments.slow_motion.empty()) document.a.slow_motion = parse_slow_motion(arguments.slow_motion);
  if (!arguments.film.empty()) {
    if (!document.a.slow_motion) throw InputError("--film: needs --slow-motion");
    make_folder(arguments.film);
  }
  for (const LeftOut& one : left_out(scene_traits(document.scene), document.a.settings))
    fmt::print(stderr, "{}\n", one.sentence);
  Prepared prepared;
  RenderRequest request;
  request.channels = shown_channel(show).needs;
  if (document.field) request.field = std::make_shared<const ShownField>(*document.field);
  request.region = document.view.region;
  Image<Rgb8> levels;  // outside a region they would hold anything
  if (show == ShownChannel::colour && !request.region && !document.a.slow_motion &&
      lower_extension(arguments.output) != ".pfm") {
    require_image_size(view.width, view.height, "picture");
    levels = Image<Rgb8>(view.width, view.height, Unfilled{});
    request.levels = &levels;
  }
  const Timer timer;
  const Frame frame = render_document(document, view, request, prepared);
  const double milliseconds = timer.milliseconds();
  if (arguments.mark_vertices) {
    if (levels.empty()) throw InputError("--mark-vertices: needs the whole picture in colour, as .png or .ppm");
    mark_vertices(document, view, levels);
  }
  save_picture(arguments, document, frame, levels);
  if (!arguments.film.empty()) save_film(arguments, document, view, request, prepared);
  if (!arguments.stats.empty()) write_file_atomically(arguments.stats, stats_json(document, view, frame, milliseconds));
  return 0;
}

}  // namespace

void add_render_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("render", "render a scene");
  const auto arguments = std::make_shared<RenderArguments>();
  add_scene_arguments(*command, arguments->scene);
  command->add_option("--out", arguments->output, "the file to write: .png, .ppm or .pfm")->required();
  std::string views;
  for (const ShownChannelRow& row : shown_channels()) views += fmt::format("{}{}", views.empty() ? "" : " ", row.key);
  command->add_option("--show", arguments->show, "the channel to show, in a .pfm file as its numbers: " + views)
      ->type_name("VIEW");
  command
      ->add_option("--field", arguments->field,
                   "a number of the pixel's story to show for every pixel: 'hit: t', 'light 1: n-dot-l', 'listing-line "
                   "29 sphere red: discriminant'")
      ->type_name("EVENT: NUMBER");
  command->add_option("--mark", arguments->mark, "mark the pixels whose number meets it: '< 0.001'")
      ->type_name("CONDITION");
  command->add_option("--region", arguments->region, "only these pixels; the others stay black")
      ->delimiter(',')
      ->expected(4)
      ->check(whole_number_from(std::numeric_limits<int>::min(), std::numeric_limits<int>::max()))
      ->type_name("X,Y,W,H");
  command
      ->add_option("--ppm", arguments->ppm,
                   "encoding of a .ppm file: binary (P6, the default), or ascii (P3), which an editor can show")
      ->check(CLI::IsMember({"ascii", "binary"}))
      ->type_name("ascii|binary");
  std::string units;
  for (const SlowUnitRow& row : slow_units()) units += fmt::format("{}{}", units.empty() ? "" : " ", row.key);
  command
      ->add_option("--slow-motion", arguments->slow_motion,
                   "the picture after the first N, in the order of the clear path on one thread: " + units)
      ->type_name("UNIT:N");
  command->add_option("--film", arguments->film, "also save pictures on the way to N into this folder")
      ->type_name("FOLDER");
  command->add_option("--film-pictures", arguments->film_pictures, "how many, 24 unless given")
      ->check(whole_number_from(1, 9999))
      ->needs("--film");
  command->add_flag("--mark-vertices", arguments->mark_vertices,
                    "set the pixels of projected vertices to magenta, to check a projection");
  command->add_option("--stats", arguments->stats, "a JSON file for times and counters");
  command->callback([&chosen, arguments] { chosen = [arguments] { return run_render(*arguments); }; });
}

}  // namespace ps::cli
