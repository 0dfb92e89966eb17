#include <fmt/format.h>

#include <memory>

#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/scene_arguments.h"
#include "document/number_list.h"
#include "inspect/describe.h"
#include "inspect/number_text.h"
#include "inspect/story_json.h"
#include "math/conventions.h"
#include "render/render.h"

namespace ps::cli {
namespace {

struct InspectArguments {
  SceneArguments scene;
  std::string pixel;
  bool json = false;
};

int depth_of(const PixelStory& story, std::size_t index) {
  int depth = 0;
  for (int above = story.events[index].parent; above >= 0; above = story.events[static_cast<std::size_t>(above)].parent)
    ++depth;
  return depth;
}

void print_story(const PixelStory& story, const Scene& scene, const View& view) {
  const Vec2i book = book_pixel(story.pixel.x, story.pixel.y, view.width, view.height);
  fmt::print("pixel ({}, {}), in the book's count ({}, {})\n", story.pixel.x, story.pixel.y, book.x, book.y);
  fmt::print("{}\n", story.verdict);
  fmt::print("linear {}, stored as {}, {}, {}\n\n", vector_text(story.linear), story.display[0], story.display[1],
             story.display[2]);
  for (std::size_t i = 0; i < story.events.size(); ++i)
    fmt::print("{:{}}{}\n", "", 2 * depth_of(story, i), describe(story.events[i], scene));
  if (story.triangles_elsewhere > 0) fmt::print("{} triangles lie elsewhere\n", story.triangles_elsewhere);
  fmt::print("\n");
  for (const LedgerLine& line : story.ledger)
    fmt::print("{:<32}{:{}}{}\n", line.value == Vec3d{0, 0, 0} ? "" : vector_text(line.value), "", 2 * line.level,
               line.term);
}

int run_inspect(const InspectArguments& arguments) {
  const Vec2i pixel = parse_pixel_text(arguments.pixel);
  const Document document = load_document(arguments.scene);
  const View view = view_of(document);
  if (pixel.x >= view.width || pixel.y >= view.height)
    throw InputError(fmt::format("pixel: found {},{}, expected one inside the picture of {} x {}", pixel.x, pixel.y,
                                 view.width, view.height));
  Prepared prepared;
  const PixelStory story =
      inspect(document.scene, view, document.a.settings, pixel, prepared, interruptible_progress());
  if (arguments.json)
    fmt::print("{}\n", story_json(story, document.scene, view));
  else
    print_story(story, document.scene, view);
  return 0;
}

}  // namespace

void add_inspect_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("inspect", "tell how one pixel got its colour");
  const auto arguments = std::make_shared<InspectArguments>();
  add_scene_arguments(*command, arguments->scene);
  command->add_option("--pixel", arguments->pixel, "column and row, counted from the top left")
      ->type_name("X,Y")
      ->delimiter('\0')
      ->required();
  command->add_flag("--json", arguments->json, "as JSON, with all digits");
  command->callback([&chosen, arguments] { chosen = [arguments] { return run_inspect(*arguments); }; });
}

}  // namespace ps::cli
