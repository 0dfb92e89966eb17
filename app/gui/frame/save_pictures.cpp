#include <fmt/format.h>

#include "base/check.h"
#include "base/kept_inputs.h"
#include "document/document_provenance.h"
#include "document/permalink_file.h"
#include "gui/frame/app.h"
#include "image/file.h"
#include "scene/load.h"
#include "scene/scene_writer.h"

namespace ps::gui {

/// Writes what is shown of A and B to NAME-a.png and NAME-b.png, and of the difference to NAME-difference.png when it
/// is on the screen. The permalink goes along, so that the state can be had again from the file.
void App::save_pictures(const std::filesystem::path& path) {
  const auto texts_of = [&](Side side) {
    return SaveOptions{image_texts(document_provenance(session_.document(), side))};
  };
  auto named = [&](const char* suffix) {
    auto result = path;
    std::string extension = path.extension().string();
    if (extension.empty()) extension = ".png";
    result.replace_filename(path.stem().string() + suffix + extension);
    return result;
  };
  const std::vector<std::string> inputs = files_of(session_.document().base);
  try {
    for (const char* suffix : {"-a", "-b", "-difference"}) require_no_input(named(suffix), inputs);
    for (const Side side : both_sides)
      save_image(named(side == Side::a ? "-a" : "-b"), pictures_.pictures[index_of(side)].levels, texts_of(side));
    const bool difference = session_.document().compare == CompareMode::difference;
    if (difference) save_image(named("-difference"), pictures_.difference.levels, texts_of(Side::a));
    session_.say(Message::Kind::information,
                 fmt::format("Saved {} and {}{}.", named("-a").string(), named("-b").filename().string(),
                             difference ? " and the difference" : ""));
  } catch (const InputError& error) {
    session_.say(Message::Kind::error, error.what());
  }
}

/// Writes the scene as it is now, with its edits and the camera that is looked through.
void App::save_scene_as(std::filesystem::path path) {
  if (path.extension().empty()) path += ".scene";
  try {
    std::vector<std::string> inputs = files_of(session_.document().base);
    // A scene may be saved over itself; a model that was opened by itself, and what a scene includes, may not.
    if (!inputs.empty() && std::filesystem::path(inputs.front()).extension() == ".scene") inputs.erase(inputs.begin());
    require_no_input(path, inputs);
    Scene scene = session_.scene();
    scene.camera = session_.view().camera;
    save_scene(scene, path);
    session_.say(Message::Kind::information, fmt::format("Saved {}.", path.string()));
  } catch (const InputError& error) {
    session_.say(Message::Kind::error, error.what());
  }
}

void App::save_chart(const std::filesystem::path& path) {
  try {
    require_no_input(path, files_of(session_.document().base));
    export_chart(studies_.chart(), path);
    session_.say(Message::Kind::information, fmt::format("Saved {}.", path.string()));
  } catch (const InputError& error) {
    session_.say(Message::Kind::error, error.what());
  }
}

/// Writes everything on the screen as a file of one line, which opens as a scene does.
void App::save_permalink_as(std::filesystem::path path) {
  if (path.extension() != permalink_extension) path += permalink_extension;
  try {
    require_no_input(path, files_of(session_.document().base));
    save_permalink(path, session_.document());
    session_.say(Message::Kind::information, fmt::format("Saved {}.", path.string()));
  } catch (const InputError& error) {
    session_.say(Message::Kind::error, error.what());
  }
}

}  // namespace ps::gui
