#include "gui/frame/shots.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cstdlib>

#include "base/check.h"
#include "document/document_provenance.h"
#include "image/file.h"

namespace ps::gui {
namespace {

std::tm local_time_now() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  return local;
}

std::string name_now(const Session& session) { return shot_name(session.document().scene_name, local_time_now()); }

void save_both(Session& session, const PicturesState& pictures) {
  const std::filesystem::path folder = shot_folder();
  const std::string name = name_now(session);
  try {
    std::array<std::filesystem::path, 2> files;
    for (const Side side : both_sides) {
      auto& file = files[index_of(side)];
      file = free_shot(folder, name, side == Side::a ? "-a" : "-b");
      save_image(file, pictures.pictures[index_of(side)].levels,
                 SaveOptions{image_texts(document_provenance(session.document(), side, {}, file))});
    }
    session.say(Message::Kind::information,
                fmt::format("Saved {} and {}.", files[0].string(), files[1].filename().string()));
  } catch (const InputError& error) {
    session.say(Message::Kind::error, error.what());
  }
}

void save_window(Session& session, const Image<Rgb8>& shot) {
  try {
    const std::filesystem::path file = free_shot(shot_folder(), name_now(session), "-window");
    save_image(file, shot, SaveOptions{image_texts(document_provenance(session.document(), Side::a, {}, file))});
    session.say(Message::Kind::information, fmt::format("Saved {}.", file.string()));
  } catch (const InputError& error) {
    session.say(Message::Kind::error, error.what());
  }
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

std::filesystem::path shot_folder() {
  if (const char* pictures = std::getenv("XDG_PICTURES_DIR"); pictures && *pictures) return pictures;
  return std::filesystem::current_path();
}

std::filesystem::path free_shot(const std::filesystem::path& folder, const std::string& name,
                                const std::string& suffix) {
  std::filesystem::path file = folder / (name + suffix + ".png");
  for (int number = 2; std::filesystem::exists(file); ++number)
    file = folder / fmt::format("{}-{}{}.png", name, number, suffix);
  return file;
}

void add_shot_actions(Actions& actions, Session& session, const PicturesState& pictures, const AskShot& ask) {
  ActionGroup scene(actions, "Scene", [&session] { return session.has_scene(); });
  scene.add("shot-pictures", "Save both pictures now, named after scene and time", "Shift+P",
            [&session, &pictures] { save_both(session, pictures); });
  scene.add("shot-window", "Save a picture of the window now, named after scene and time", "Ctrl+P",
            [&session, ask] { ask([&session](const Image<Rgb8>& shot) { save_window(session, shot); }); });
}

}  // namespace ps::gui
