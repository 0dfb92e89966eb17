#include "cli/scene_arguments.h"

#include <fmt/format.h>

#include <cstdio>

#include "base/check.h"
#include "document/number_list.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"

namespace ps::cli {

void add_scene_arguments(CLI::App& command, SceneArguments& arguments) {
  command.add_option("SCENE", arguments.scene, "a .scene or .obj file, or the name of a built-in scene")->required();
  command.add_option("--size", arguments.size, "picture size in pixels; the scene's own without it")->type_name("WxH");
  command.add_option("--set", arguments.settings, "set an option; see the command 'options'")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--edit", arguments.edits, "change the scene, for example light.1.intensity=0.5")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  command
      .add_option(
          "--camera", arguments.camera,
          "camera in place of the scene's, 15 numbers with commas between: position, right, up, forward, viewport "
          "size, distance")
      ->type_name("X,Y,Z,...")
      ->delimiter('\0');
}

SceneEdit parse_edit(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) throw InputError("--edit: found '" + text + "', expected PATH=VALUE");
  return {text.substr(0, equals), text.substr(equals + 1)};
}

Document load_document(const SceneArguments& arguments) {
  PictureView view;
  if (!arguments.size.empty()) {
    const Vec2i size = parse_size_text(arguments.size);
    view.width = size.x;
    view.height = size.y;
  }
  if (!arguments.camera.empty()) view.camera = parse_camera_text(arguments.camera);
  Settings trial;
  for (const std::string& assignment : arguments.settings) parse_assignment(assignment, trial);

  Scene scene = load_scene(arguments.scene);
  for (const std::string& warning : scene.warnings) fmt::print(stderr, "{}\n", warning);
  const Settings start = settings_for(scene);
  Document document = open_document(arguments.scene, std::move(scene));
  for (const std::string& edit : arguments.edits) edit_scene(document, parse_edit(edit));
  document.view = view;
  document.a.settings = start;
  for (const std::string& assignment : arguments.settings) parse_assignment(assignment, document.a.settings);
  return document;
}

}  // namespace ps::cli
