#include "gui/session/scene_contents.h"

#include <fmt/format.h>

#include <cmath>

#include "gui/session/camera_moves.h"
#include "gui/session/handles.h"
#include "render/story/names.h"
#include "scene/object_boxes.h"

namespace ps::gui {
namespace {

constexpr double before_scene = 0.6;   // share of the way to the scene's centre at which new things come
constexpr double object_size = 0.2;    // of a new one, as a share of that way
constexpr double light_rise = 0.15;    // of a copied light, the same
constexpr double copy_distance = 1.1;  // of a copied object, in widths of it

Vec3d new_place(const Session& session) {
  const View view = session.view();
  const Vec3d towards = view.camera.position + before_scene * (scene_centre(session.scene()) - view.camera.position);
  const Vec2d middle{view.width / 2.0, view.height / 2.0};
  const auto pixel = session.pixel();
  const Vec3d place =
      position_at(view, session.settings(inspected_side(session)), towards, pixel ? Vec2d(*pixel) + 0.5 : middle);
  const bool finite = std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z);
  return finite ? place : towards;
}

double reach_of(const Session& session) { return before_scene * scene_reach(session.scene(), session.view().camera); }

/// Changes that are one step in the history.
void change(Session& session, const std::string& what, const std::vector<SceneEdit>& edits) {
  session.edit(what, [&](Document& document) {
    for (const SceneEdit& edit : edits) edit_scene(document, edit);
  });
}

/// How far to the right a copy lies beside its original.
double width_of(const Session& session, std::size_t object) {
  const Geometry& all = *session.scene().geometry;
  const FormBox box = boxes_of_objects(Geometry{all.meshes, {all.objects[object]}}).front();
  const Vec3d right = session.view().camera.right, size = box.high - box.low;
  const double width = std::abs(size.x * right.x) + std::abs(size.y * right.y) + std::abs(size.z * right.z);
  return std::isfinite(width) && width > 0 ? width : object_size * reach_of(session);
}

}  // namespace

void add_object(Session& session, PickedObject& picked, std::string_view kind) {
  if (!session.has_scene()) return;
  const std::size_t index = session.scene().geometry->objects.size();
  const double size = object_size * reach_of(session);
  const bool round = kind == "sphere";
  change(session, fmt::format("add a {}", kind),
         {{"object.add", std::string(kind)},
          {fmt::format("object.{}.center", index), brief_place(new_place(session))},
          {fmt::format("object.{}.{}", index, round ? "radius" : "size"),
           round ? fmt::format("{:.4g}", size / 2) : brief_place(Vec3d(size))}});
  picked.choose(index);
}

void duplicate_object(Session& session, PickedObject& picked) {
  const auto object = picked.index(session);
  if (!object) return;
  const std::size_t index = session.scene().geometry->objects.size();
  const Vec3d by = session.view().camera.right * (copy_distance * width_of(session, *object));
  change(session, "duplicate " + object_name(session.scene(), static_cast<int>(*object)),
         {{"object.copy", fmt::format("{} + {}", *object, brief_place(by))}});
  picked.choose(index);
}

void remove_object(Session& session, PickedObject& picked) {
  const auto object = picked.index(session);
  if (!object) return;
  change(session, "delete " + object_name(session.scene(), static_cast<int>(*object)),
         {{"object.remove", std::to_string(*object)}});
  picked.choose({});
}

void add_light(Session& session, int& selected, std::string_view kind) {
  if (!session.has_scene()) return;
  const std::size_t index = session.scene().lights->size();
  const Camera camera = session.view().camera;
  const bool point = kind == "point";
  change(session, fmt::format("add a {} light", kind),
         {{"light.add", std::string(kind)},
          {fmt::format("light.{}.{}", index, point ? "position" : "direction"),
           brief_place(point ? new_place(session) : camera.right + camera.up - camera.forward)}});
  selected = static_cast<int>(index);
}

void duplicate_light(Session& session, int& selected, std::size_t light) {
  const std::size_t index = session.scene().lights->size();
  const Vec3d by = session.view().camera.up * (light_rise * reach_of(session));
  change(session, fmt::format("duplicate light {}", light),
         {{"light.copy", fmt::format("{} + {}", light, brief_place(by))}});
  selected = static_cast<int>(index);
}

void remove_light(Session& session, std::size_t light) {
  change(session, fmt::format("delete light {}", light), {{"light.remove", std::to_string(light)}});
}

}  // namespace ps::gui
