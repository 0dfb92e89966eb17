#include "gui/panels/pictures/dropped_picture.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "gui/widgets/widgets.h"
#include "render/story/names.h"
#include "scene/object_surface.h"
#include "scene/scene_text.h"

namespace ps::gui {
namespace {

std::vector<int> textured_objects(const Scene& scene) {
  std::vector<int> objects;
  for (std::size_t i = 0; i < scene.geometry->objects.size(); ++i)
    if (takes_texture(scene, i)) objects.push_back(static_cast<int>(i));
  return objects;
}

void put_on(Session& session, const DroppedPicture& state) {
  const std::string name = object_name(session.scene(), state.object);
  const std::string path = fmt::format("object.{}", state.object);
  const std::size_t warnings = session.scene().warnings.size();
  bool done = false;
  session.edit(fmt::format("texture of {}: {}", name, state.file.filename().string()), [&](Document& document) {
    edit_scene(document, {path + ".texture", scene_name(std::filesystem::absolute(state.file).string())});
    if (state.plain) edit_scene(document, {path + ".color", "white"});
    done = true;
  });
  if (done)
    session.say(Message::Kind::information,
                fmt::format("{} is the texture of {} now. Undo removes it; save the scene to keep it.",
                            state.file.filename().string(), name));
  for (std::size_t i = warnings; i < session.scene().warnings.size(); ++i)
    session.say(Message::Kind::warning, session.scene().warnings[i]);
}

void object_choice(const Scene& scene, DroppedPicture& state) {
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
    if (objects[i] == state.object) index = static_cast<int>(i);
  }
  choice("object", choices, index, {.tooltip = "The object that gets the picture as its texture.", .width = px(200)});
  state.object = objects[static_cast<std::size_t>(index)];
}

}  // namespace

void ask_about_picture(Session& session, DroppedPicture& state, const std::filesystem::path& file, int object) {
  if (!session.has_scene()) return;
  const std::vector<int> objects = textured_objects(session.scene());
  if (objects.empty()) return session.open_picture_b(file);
  state = {};
  state.file = file;
  state.object =
      object >= 0 && takes_texture(session.scene(), static_cast<std::size_t>(object)) ? object : objects.front();
}

void dropped_picture(Session& session, DroppedPicture& state) {
  if (state.file.empty()) return;
  // Another scene may have come meanwhile.
  if (!takes_texture(session.scene(), static_cast<std::size_t>(state.object))) return void(state = {});
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(px(520), display.x - px(40)), 0});
  if (!std::exchange(state.shown, true)) ImGui::SetNextWindowFocus();  // once, else the list of objects could not open
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(24), px(16)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, px(6));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette().field);
  ImGui::Begin("##dropped", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
  bool answered = false;
  {
    const NameScope scope("dropped");
    {
      const FontScope title(Face::heading);
      value_text("file", state.file.filename().string());
    }
    ImGui::TextUnformatted("What is this picture for?");
    ImGui::Dummy({0, px(8)});
    if (button("compare", "Compare it with A", Emphasis::primary,
               {.tooltip = "Replaces B; A is rendered in its size."})) {
      session.open_picture_b(state.file);
      answered = true;
    }
    ImGui::Dummy({0, px(8)});
    if (button("texture", "Put it on", Emphasis::primary,
               {.tooltip = "It becomes the object's texture. This can be undone, and is saved with the scene."})) {
      put_on(session, state);
      answered = true;
    }
    ImGui::SameLine();
    object_choice(session.scene(), state);
    toggle("plain", "in its original colours", state.plain,
           {.tooltip = "The colour of an object multiplies its texture. On: the object becomes white."});
    ImGui::Dummy({0, px(8)});
    if (button("cancel", "Cancel", Emphasis::quiet)) answered = true;
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
  if (answered) state = {};
}

}  // namespace ps::gui
