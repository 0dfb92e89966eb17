#include "cli/scene_arguments.h"

#include <utility>

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "base/archived_file.h"
#include "base/check.h"
#include "base/extension.h"
#include "base/spelling.h"
#include "cli/output_file.h"
#include "document/number_list.h"
#include "document/permalink.h"
#include "document/permalink_file.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"

namespace ps::cli {

void add_scene_arguments(CLI::App& command, SceneArguments& arguments) {
  command.add_option("SCENE", arguments.scene,
                     "a .scene or .obj file, or the name of a built-in scene; not needed with --permalink");
  command
      .add_option("--permalink", arguments.permalink,
                  "start from a permalink (scene, edits, camera, size, settings, pixel, rectangle): its text, or a "
                  ".permalink or .png file with one. Other arguments override it")
      ->type_name("TEXT|FILE");
  command.add_option("--side", arguments.side, "which picture of the permalink; default: the picked one")
      ->type_name("a|b");
  command.add_option("--size", arguments.size, "picture size in pixels; default: that of the scene")->type_name("WxH");
  command.add_option("--set", arguments.settings, "set an option; see the command 'options'")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--edit", arguments.edits, "edit the scene, for example light.1.intensity=0.5")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  command
      .add_option("--camera", arguments.camera,
                  "replace the scene's camera: 15 numbers separated by commas: position, right, up, forward, viewport "
                  "size, distance")
      ->type_name("X,Y,Z,...")
      ->delimiter('\0');
}

SceneEdit parse_edit(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) throw InputError("--edit: found '" + text + "', expected PATH=VALUE");
  return {text.substr(0, equals), text.substr(equals + 1)};
}

namespace {

/// The link in a file, or the text itself.
std::string link_text(const std::string& text_or_file) {
  const std::string extension = lower_extension(text_or_file);
  const bool has_parts = text_or_file.find('=') != std::string::npos;
  std::error_code error;
  if (has_parts && !std::filesystem::exists(text_or_file, error)) return text_or_file;
  if (extension != permalink_extension && extension != ".png" && extension != archive_extension)
    throw InputError(
        fmt::format("--permalink: found '{}', expected a permalink, or a .permalink, .png or .tar file with one",
                    shown_start(text_or_file)));
  if (const auto link = permalink_in_file(text_or_file)) return *link;
  throw InputError(fmt::format("{}: contains no permalink", text_or_file));
}

/// The side that was asked for becomes side A.
void choose_side(Document& document, const std::string& asked) {
  if (!asked.empty() && asked != "a" && asked != "b")
    throw InputError(fmt::format("--side: found '{}', expected a or b", asked));
  const Side side = asked.empty() ? document.picked : asked == "a" ? Side::a : Side::b;
  if (side == Side::b && !document.picture_b.empty())
    throw InputError(
        fmt::format("--side: b of this permalink is the picture file '{}', which is not rendered", document.picture_b));
  document.a = side_of(document, side);
  document.picked = Side::a;
}

Document open_link(const SceneArguments& arguments) {
  Document document = parse_permalink(link_text(arguments.permalink));
  choose_side(document, arguments.side);
  if (!arguments.scene.empty()) document.scene_name = arguments.scene;
  if (document.scene_name.empty()) throw InputError("--permalink: it names no scene, so SCENE is required");
  attach_scene(document, load_scene(document.scene_name));
  return document;
}

}  // namespace

Document load_document(const SceneArguments& asked) {
  SceneArguments arguments = asked;
  if (std::filesystem::path(arguments.scene).extension() == archive_extension) {  // a bundle brings its settings along
    if (!arguments.permalink.empty())
      throw InputError(fmt::format("{}: a bundle has its own permalink, so it excludes --permalink", arguments.scene));
    arguments.permalink = std::exchange(arguments.scene, {});
  }
  PictureView view;
  if (!arguments.size.empty()) {
    const Vec2i size = parse_size_text(arguments.size);
    view.width = size.x;
    view.height = size.y;
  }
  if (!arguments.camera.empty()) view.camera = parse_camera_text(arguments.camera);
  Settings trial;
  for (const std::string& assignment : arguments.settings) parse_assignment(assignment, trial);
  const bool linked = !arguments.permalink.empty();
  if (arguments.scene.empty() && !linked) throw InputError("SCENE is required");
  if (!arguments.side.empty() && !linked) throw InputError("--side: needs --permalink");

  Document document = linked ? open_link(arguments) : open_document(arguments.scene, load_scene(arguments.scene));
  for (const std::string& edit : arguments.edits) edit_scene(document, parse_edit(edit));
  for (const std::string& warning : document.scene.warnings) fmt::print(stderr, "{}\n", warning);
  if (!linked) document.a.settings = settings_for(document.base);
  if (!arguments.size.empty()) {
    document.view.width = view.width;
    document.view.height = view.height;
  }
  if (view.camera) document.view.camera = view.camera;
  fit_region(document);
  for (const std::string& assignment : arguments.settings) parse_assignment(assignment, document.a.settings);
  return document;
}

}  // namespace ps::cli
