#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/check.h"
#include "base/enumerators.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/scene_arguments.h"
#include "document/document_provenance.h"
#include "document/number_list.h"
#include "frame/display_frame.h"
#include "image/file.h"
#include "inspect/missing_term.h"
#include "render/provenance_json.h"
#include "render/render.h"
#include "study/missing_feature.h"

namespace ps::cli {
namespace {

constexpr std::size_t most_printed = 10;  // of the changes alone

struct MissingArguments {
  SceneArguments scene;
  std::string file, pixel;
  bool json = false;
};

/// The sum of one pixel beside the file.
struct PixelAnswer {
  PixelStory story;
  MissingTerm term;
};

PixelAnswer ask_pixel(const Document& document, const View& view, const Image<Rgb8>& file, Vec2i pixel) {
  if (!file.contains(pixel.x, pixel.y))
    throw InputError(fmt::format("--pixel: found {},{}, expected one inside the picture of {} x {}", pixel.x, pixel.y,
                                 file.width(), file.height()));
  Prepared prepared;
  PixelAnswer answer{inspect(document.scene, view, document.a.settings, pixel, prepared, interruptible_progress()), {}};
  answer.term = find_missing_term(answer.story, display_transform(document.a.settings), file.at(pixel.x, pixel.y));
  return answer;
}

nlohmann::ordered_json match_json(const MissingMatch& match) {
  return {{"changes", match.keys}, {"words", missing_words(match)}, {"pixels", match.pixels},
          {"equal", match.equal},  {"within-one", match.near},      {"mean", match.mean}};
}

void print_json(const MissingArguments& arguments, const MissingFeature& found, const std::optional<PixelAnswer>& pixel,
                const nlohmann::ordered_json& made) {
  nlohmann::ordered_json json{
      {"scene", arguments.scene.scene},           {"file", arguments.file},
      {"verdict", enumerator_key(found.verdict)}, {"sentence", missing_sentence(found, arguments.file)},
      {"as-is", match_json(found.as_is)},         {"best", match_json(found.best)},
      {"candidates", found.candidates},           {"renders", found.renders}};
  json["alone"] = nlohmann::ordered_json::array();
  for (const MissingMatch& match : found.single) json["alone"].push_back(match_json(match));
  if (pixel) {
    json["pixel"] = {{"at", {pixel->story.pixel.x, pixel->story.pixel.y}},
                     {"difference", pixel->term.difference},
                     {"sentence", pixel->term.sentence}};
    json["pixel"]["rows"] = nlohmann::ordered_json::array();
    for (const TermRow& row : pixel->term.rows)
      json["pixel"]["rows"].push_back({{"term", pixel->story.ledger[row.line].term}, {"adds", row.adds}});
  }
  json["provenance"] = made;
  fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

void print_pixel(const PixelAnswer& pixel) {
  const auto levels = [](const std::array<int, 3>& l) { return fmt::format("{:>5} {:>5} {:>5}", l[0], l[1], l[2]); };
  fmt::print("\npixel ({}, {}): {}\n", pixel.story.pixel.x, pixel.story.pixel.y, pixel.term.sentence);
  fmt::print("{}  the file minus A, in levels of 255: red, green, blue\n", levels(pixel.term.difference));
  for (const TermRow& row : pixel.term.rows) {
    const LedgerLine& line = pixel.story.ledger[row.line];
    fmt::print("{}  {:>{}}{}\n", levels(row.adds), "", 2 * line.level, line.term);
  }
}

void print_text(const MissingArguments& arguments, const MissingFeature& found,
                const std::optional<PixelAnswer>& pixel) {
  fmt::print("{}\n", missing_sentence(found, arguments.file));
  if (!found.single.empty()) fmt::print("\n{:>9} {:>11} {:>8}  one change alone\n", "equal", "within one", "mean");
  for (std::size_t i = 0; i < std::min(most_printed, found.single.size()); ++i) {
    const MissingMatch& match = found.single[i];
    fmt::print("{:>7.2f} % {:>9.2f} % {:>8.3g}  {}\n", 100 * match.equal_share(), 100 * match.near_share(), match.mean,
               missing_words(match));
  }
  if (pixel) print_pixel(*pixel);
}

int run_missing(const MissingArguments& arguments) {
  std::optional<Vec2i> asked;
  if (!arguments.pixel.empty()) asked = parse_pixel_text(arguments.pixel);
  Document document = load_document(arguments.scene);
  MissingRequest request;
  request.file = load_levels(arguments.file);
  if (arguments.scene.size.empty()) {
    document.view.width = request.file.width();
    document.view.height = request.file.height();
    document.view.region.reset();
  }
  request.scene = document.scene;
  request.view = view_of(document);
  request.settings = document.a.settings;
  StudyControl control;
  forward_interrupts(control.progress());
  std::optional<PixelAnswer> pixel;
  if (asked) pixel = ask_pixel(document, request.view, request.file, *asked);
  const MissingFeature found = find_missing_feature(request, control);
  if (arguments.json)
    print_json(arguments, found, pixel, provenance_json(document_provenance(document, Side::a)));
  else
    print_text(arguments, found, pixel);
  return 0;
}

}  // namespace

void add_missing_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("missing", "what a picture file has less, more or otherwise than the scene");
  const auto arguments = std::make_shared<MissingArguments>();
  add_scene_arguments(*command, arguments->scene);
  command->add_option("FILE", arguments->file, "the picture file; the scene is rendered in its size")->required();
  command->add_option("--pixel", arguments->pixel, "compare this pixel with each row of its sum: column,row from 0")
      ->type_name("X,Y");
  command->add_flag("--json", arguments->json, "as JSON");
  command->callback([&chosen, arguments] { chosen = [arguments] { return run_missing(*arguments); }; });
}

}  // namespace ps::cli
