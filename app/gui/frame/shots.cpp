#include "gui/frame/shots.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cstdlib>

#include "gui/frame/exports.h"

namespace ps::gui {
namespace {

std::tm local_time_now() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  return local;
}

/// A new file named after scene and time, followed by `ending`; a file with `suffix` is not there yet.
std::filesystem::path free_file(const Session& session, const ShotHost& host, std::string_view suffix,
                                std::string_view ending) {
  const std::filesystem::path folder = shot_folder(host.last_folder());
  const std::string name = shot_name(session.document().scene_name, local_time_now());
  return folder / fmt::format("{}{}.png", free_name(folder, name, suffix), ending);
}

}  // namespace

std::string shot_name(const std::string& scene, const std::tm& time) {
  std::string name = scene;
  if (std::filesystem::path(scene).is_absolute()) name = std::filesystem::path(scene).stem().string();
  if (name.ends_with(".scene")) name.resize(name.size() - 6);
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_') c = '-';
  std::array<char, 32> stamp{};
  std::strftime(stamp.data(), stamp.size(), "%Y%m%d-%H%M%S", &time);
  return fmt::format("{}-{}", name, stamp.data());
}

std::filesystem::path shot_folder(const std::filesystem::path& last) {
  if (const char* pictures = std::getenv("XDG_PICTURES_DIR"); pictures && *pictures) return pictures;
  return last;
}

std::string free_name(const std::filesystem::path& folder, const std::string& name, std::string_view suffix) {
  std::string found = name;
  for (int number = 2; std::filesystem::exists(folder / fmt::format("{}{}.png", found, suffix)); ++number)
    found = fmt::format("{}-{}", name, number);
  return found;
}

void add_shot_actions(Actions& actions, Session& session, const PicturesState& pictures, const ShotHost& host) {
  ActionGroup scene(actions, "Scene", [&session] { return session.has_scene(); });
  scene.add("shot-pictures", "Save both pictures now, named after scene and time", "Shift+P",
            [&session, &pictures, host] { save_pictures(session, pictures, free_file(session, host, "-a", "")); });
  scene.add("shot-window", "Save a picture of the window now, named after scene and time", "Ctrl+P", [&session, host] {
    host.ask([&session, host](const Image<Rgb8>& shot) {
      save_picture(session, shot, free_file(session, host, "-window", "-window"));
    });
  });
}

}  // namespace ps::gui
