#include "gui/frame/shots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <vector>

#include "base/check.h"
#include "document/document_provenance.h"
#include "gui/frame/exports.h"
#include "gui/frame/slide_picture.h"
#include "gui/panels/pictures/caption.h"
#include "gui/panels/pictures/difference_scale.h"
#include "gui/panels/pictures/picture_frame.h"
#include "gui/platform/picture_clipboard.h"
#include "image/file.h"

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

/// "A: ray tracer, 3 reflections" above the picture, and its counted work below.
SlidePart slide_part(Session& session, const PicturesState& pictures, Side side) {
  SlidePart part;
  part.title = fmt::format("{}: {}", letter_of(side), shown_title(session, side).text());
  part.picture = &pictures.pictures[index_of(side)].levels;
  if (const auto result = session.renderer(side).result(); result && !session.file_of(side))
    for (const CaptionWork& work : caption_work(*result))
      part.caption += (part.caption.empty() ? "" : ", ") + work_text(work);
  return part;
}

/// The pictures that are on the screen, as one.
void save_for_slides(Session& session, const PicturesState& pictures, const ShotHost& host) {
  const CompareMode compare = session.document().compare;
  std::vector<SlidePart> parts;
  if (compare != CompareMode::only_b) parts.push_back(slide_part(session, pictures, Side::a));
  if (compare != CompareMode::only_a) parts.push_back(slide_part(session, pictures, Side::b));
  if (const ShownDifference& shown = pictures.difference; compare == CompareMode::difference)
    parts.push_back({"Difference, B − A", difference_numbers_text(shown.numbers, shown.mode), &shown.picture.levels});
  if (std::any_of(parts.begin(), parts.end(), [](const SlidePart& part) { return part.picture->empty(); }))
    return session.say(Message::Kind::warning, "The pictures are not drawn yet.");
  const std::filesystem::path file = free_file(session, host, "-slide", "-slide");
  session.say_saved([&] {
    save_image(file, slide_picture(parts), {image_texts(document_provenance(session.document(), Side::a, {}, file))});
    host.copy(file.string());
    const char* on_clipboard = copy_picture(file) ? "the picture" : "this path";
    return fmt::format("Saved {}; on the clipboard is {}.", file.string(), on_clipboard);
  });
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
  scene.add("save-slide", "Save for slides: the pictures with their titles as one, twice as large", "",
            [&session, &pictures, host] { save_for_slides(session, pictures, host); });
}

}  // namespace ps::gui
