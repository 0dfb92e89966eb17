#include "gui/panels/pictures/dropped_picture.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "gui/widgets/widgets.h"
#include "render/story/names.h"
#include "scene/scene_text.h"

namespace ps::gui {
namespace {

std::vector<int> textured_objects(const Scene& scene) {
  std::vector<int> objects;
  for (std::size_t i = 0; i < scene.geometry->objects.size(); ++i)
    if (takes_texture(scene, i)) objects.push_back(static_cast<int>(i));
  return objects;
}

}  // namespace

void DroppedPicture::put_on() {
  const std::string name = object_name(session_.scene(), object_);
  const std::string path = fmt::format("object.{}", object_);
  const std::size_t warnings = session_.scene().warnings.size();
  bool done = false;
  session_.edit(fmt::format("texture of {}: {}", name, file_.filename().string()), [&](Document& document) {
    edit_scene(document, {path + ".texture", scene_name(std::filesystem::absolute(file_).string())});
    if (plain_) edit_scene(document, {path + ".color", "white"});
    done = true;
  });
  if (done)
    session_.say(Message::Kind::information,
                 fmt::format("{} is the texture of {} now. Undo removes it; save the scene to keep it.",
                             file_.filename().string(), name));
  for (std::size_t i = warnings; i < session_.scene().warnings.size(); ++i)
    session_.say(Message::Kind::warning, session_.scene().warnings[i]);
}

void DroppedPicture::object_choice() {
  const Scene& scene = session_.scene();
  const std::vector<int> objects = textured_objects(scene);
  std::vector<std::string> names, keys;
  names.reserve(objects.size());
  keys.reserve(objects.size());
  for (const int object : objects) {
    names.push_back(object_name(scene, object));
    keys.push_back(std::to_string(object));
  }
  std::vector<Choice> choices;
  int index = 0;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    choices.push_back({keys[i], names[i], ""});
    if (objects[i] == object_) index = static_cast<int>(i);
  }
  choice("object", choices, index, {.tooltip = "The object that gets the picture as its texture.", .width = px(200)});
  object_ = objects[static_cast<std::size_t>(index)];
}

void DroppedPicture::ask(const std::filesystem::path& file, int object) {
  if (!session_.has_scene()) return;
  const std::vector<int> objects = textured_objects(session_.scene());
  if (objects.empty()) return session_.open_picture_b(file);
  open();
  plain_ = true;
  file_ = file;
  object_ = object >= 0 && takes_texture(session_.scene(), static_cast<std::size_t>(object)) ? object : objects.front();
}

void DroppedPicture::draw_sheet() {
  value_text("file", file_.filename().string());
  ImGui::Dummy({0, px(8)});
  if (button("compare", "Compare it with A", Emphasis::primary,
             {.tooltip = "Replaces B; A is rendered in its size."})) {
    session_.open_picture_b(file_);
    open_ = false;
  }
  ImGui::Dummy({0, px(8)});
  if (button("texture", "Put it on", Emphasis::primary,
             {.tooltip = "It becomes the object's texture. This can be undone, and is saved with the scene."})) {
    put_on();
    open_ = false;
  }
  ImGui::SameLine();
  object_choice();
  toggle("plain", "in its original colours", plain_,
         {.tooltip = "The colour of an object multiplies its texture. On: the object becomes white."});
}

}  // namespace ps::gui
