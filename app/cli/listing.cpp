#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/enumerators.h"
#include "base/spelling.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/output_file.h"
#include "cli/print_listing.h"
#include "cli/scene_arguments.h"
#include "document/number_list.h"
#include "engine/lesson.h"
#include "image/file.h"
#include "options/option.h"
#include "record/value_text.h"
#include "student/check_listing.h"
#include "textbook/listing_view.h"

namespace ps::cli {
namespace {

struct ListingArguments {
  std::string name;     ///< of a lesson's folder, or key of its listing
  std::string routine;  ///< that is left to be written; empty = none
  std::string file;
  std::string pixel, out;
  SceneArguments scene;
};

const NamedListing& find_listing(const std::string& name) {
  std::vector<std::string> keys;
  for (const NamedListing& listing : listings()) {
    if (listing.key == name || listing.folder == name) return listing;
    keys.push_back(listing.key);
  }
  throw InputError(fmt::format("listing: found '{}', expected one of: {}", shown_start(name), fmt::join(keys, ", ")));
}

int run_copy(const ListingArguments& arguments) {
  ListingPermits permits;
  fmt::print("{}\n", permits.copy(find_listing(arguments.name), arguments.routine).file().string());
  return 0;
}

/// The scene that was asked for, else that of the first step of the listing's lesson of which it shows something.
Document document_for(const ListingArguments& arguments, const NamedListing& listing) {
  if (!arguments.scene.scene.empty() || !arguments.scene.permalink.empty()) return load_document(arguments.scene);
  SceneArguments others = arguments.scene;
  if (!others.size.empty() || !others.camera.empty() || !others.edits.empty() || !others.settings.empty())
    throw InputError("SCENE is required with options that change it");
  const Lesson lesson = load_lesson(listing.folder);
  Document document = lesson_document(lesson, 0, Document{});
  const auto shows_nothing = [&] {
    return listing.listing->suits(scene_traits(document.scene), document.a.settings) == 0;
  };
  for (std::size_t step = 1; step < lesson.steps.size() && shows_nothing(); ++step)
    document = lesson_document(lesson, static_cast<int>(step), Document{});
  return document;
}

void print_messages(const Compilation& compilation, const std::string& file) {
  for (const CompilerMessage& message : compilation.messages) {
    const std::string place = message.line > 0 ? fmt::format("{}:{}:{}: ", file, message.line, message.column) : "";
    fmt::print("{}{}: {}\n", place, enumerator_key(message.kind), message.text);
  }
}

int run_check(const ListingArguments& arguments) {
  if (!arguments.out.empty()) require_output_file(arguments.out, OutputKind::picture);
  std::optional<Vec2i> pixel;
  if (!arguments.pixel.empty()) pixel = parse_pixel_text(arguments.pixel);
  ListingPermits permits;  // a file named on a command line is to be run
  fmt::print("{}\n", protection_sentence());
  const Compilation compilation = compile_listing(permits.permit(arguments.file), {}, &interruptible_progress());
  print_messages(compilation, arguments.file);
  if (!compilation.program) {
    fmt::print("{}\n", compilation.failure);
    return 1;
  }
  const NamedListing* listing = copied_listing(compilation.source);
  if (!listing)
    throw InputError(fmt::format("{}: found no line '// Listing: NAME', expected one that names the listing that it is "
                                 "a copy of",
                                 arguments.file));
  const Document document = document_for(arguments, *listing);
  const View view = view_of(document);
  if (pixel && (pixel->x >= view.width || pixel->y >= view.height))
    throw InputError(fmt::format("pixel: found {},{}, expected one inside the picture of {} x {}", pixel->x, pixel->y,
                                 view.width, view.height));
  const CheckedListing checked = check_listing(*compilation.program, *listing, document.scene, view,
                                               document.a.settings, pixel, interruptible_progress());
  if (!checked.run.text.empty()) fmt::print("It printed:\n{}{}\n", checked.run.text, checked.run.text_cut ? "..." : "");
  if (!checked.run.failure.empty()) {
    fmt::print("{}\n", checked.run.failure);
    return 1;
  }
  if (!arguments.out.empty()) save_own_picture(arguments.out, checked.run.result.picture, document.a.settings);
  if (checked.run.result.trace)
    print_listing_rows(listing_trace(*checked.run.result.trace, *listing, *pixel), parse_listing(compilation.source));
  fmt::print("{}\n", verdict_text(checked.wrong, view.width, view.height));
  return checked.wrong.count == 0 ? 0 : 1;
}

}  // namespace

void add_listing_command(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand("listing", "copy a lesson's listing, and compile and check a changed copy");
  command->require_subcommand(1);
  const auto arguments = std::make_shared<ListingArguments>();

  CLI::App* copy = command->add_subcommand("copy", "make a file of your own from a listing, and print where it is");
  copy->add_option("NAME", arguments->name, "the folder of its lesson, such as cgfs_02_basic_ray_tracing")->required();
  copy->add_option("--without", arguments->routine, "leave the body of this routine to be written")
      ->type_name("ROUTINE");
  copy->callback([&chosen, arguments] { chosen = [arguments] { return run_copy(*arguments); }; });

  CLI::App* run = command->add_subcommand(
      "run", "compile a copy, run it (shut off from your files and the network where bubblewrap works, else with your "
             "rights), and compare its picture with that of the listing");
  run->add_option("FILE", arguments->file, "the file")->required();
  add_scene_arguments(*run, arguments->scene);
  run->add_option("--pixel", arguments->pixel, "show the values that its lines have for this pixel")
      ->type_name("X,Y")
      ->delimiter('\0');
  run->add_option("--out", arguments->out, "save its picture (.png, .ppm or .pfm)")->type_name("IMAGE");
  run->callback([&chosen, arguments] { chosen = [arguments] { return run_check(*arguments); }; });
}

}  // namespace ps::cli
