#include "gui/session/handles.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/matrix.hpp>

#include "frame/viewport.h"
#include "gui/session/gizmo_shapes.h"
#include "render/story/names.h"

namespace ps::gui {
namespace {

Mat3d frame_of(const Camera& camera) { return Mat3d(camera.right, camera.up, camera.forward); }

/// Pixels from the centre of the picture for one unit along the camera's right and up, at depth 1.
Vec2d pixels_per_unit(const Viewport<double>& viewport) {
  const double distance = viewport.projection == Projection::perspective ? viewport.distance : 1;
  return {distance * viewport.span_x / viewport.width, distance * viewport.span_y / viewport.height};
}

double shrink_at(const Viewport<double>& viewport, double depth) {
  return viewport.projection == Projection::perspective ? 1 / depth : 1;
}

}  // namespace

std::optional<Vec2d> place_in_picture(const View& view, const Settings& settings, const Vec3d& point) {
  const auto viewport = make_viewport<double>(view, settings);
  const Vec3d p = glm::inverse(frame_of(view.camera)) * (point - view.camera.position);
  if (!(p.z > 0)) return {};
  const Vec2d scale = pixels_per_unit(viewport);
  const double shrink = shrink_at(viewport, p.z);
  const Vec2d place{view.width / 2.0 + p.x * scale.x * shrink, view.height / 2.0 - p.y * scale.y * shrink};
  if (!std::isfinite(place.x) || !std::isfinite(place.y)) return {};
  return place;
}

Vec3d position_at(const View& view, const Settings& settings, const Vec3d& like, const Vec2d& place) {
  const auto viewport = make_viewport<double>(view, settings);
  const Mat3d frame = frame_of(view.camera);
  const double depth = (glm::inverse(frame) * (like - view.camera.position)).z;
  const Vec2d scale = pixels_per_unit(viewport);
  const double shrink = shrink_at(viewport, depth);
  const Vec3d p{(place.x - view.width / 2.0) / (scale.x * shrink), (view.height / 2.0 - place.y) / (scale.y * shrink),
                depth};
  return view.camera.position + frame * p;
}

std::vector<Handle> handles_of(const Scene& scene, const View& view, const Settings& settings) {
  std::vector<Handle> handles;
  const auto add = [&](std::string path, std::string name, const Vec3d& position, bool is_light,
                       const Vec3d& offset = Vec3d(0, 0, 0)) {
    if (const auto place = place_in_picture(view, settings, position))
      handles.push_back({std::move(path), std::move(name), position, *place, is_light, offset});
  };
  for (std::size_t i = 0; i < scene.lights->size(); ++i) {
    const Light& light = (*scene.lights)[i];
    if (light.kind == LightKind::point)
      add(fmt::format("light.{}.position", i), light_name(scene, static_cast<int>(i)), light.position, true);
  }
  const auto& objects = scene.geometry->objects;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::string name = object_name(scene, static_cast<int>(i));
    const auto* solid = std::get_if<Solid>(&objects[i].shape);
    if (solid && !solid->place.is_identity()) continue;  // its numbers are not in world space
    if (const auto* sphere = std::get_if<Sphere>(&objects[i].shape))
      add(fmt::format("object.{}.center", i), name, sphere->centre, false);
    else if (const auto* rectangle = solid ? std::get_if<Rectangle>(&solid->form) : nullptr)
      add(fmt::format("object.{}.corner", i), name, rectangle->corner, false);
    else if (const auto* brick = solid ? std::get_if<Brick>(&solid->form) : nullptr)
      add(fmt::format("object.{}.center", i), name, brick->centre, false);
    else if (const auto* instance = std::get_if<Instance>(&objects[i].shape))
      add(fmt::format("object.{}.translation", i), name, centre_of(scene, *instance), false,
          instance->transform.translation - centre_of(scene, *instance));
  }
  return handles;
}

std::string brief_place(const Vec3d& place) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", place.x, place.y, place.z);
}

void drag_handle(Session& session, Side side, const Handle& handle, const Vec2d& place) {
  const Vec3d position = position_at(session.view(), session.settings(side), handle.position, place) + handle.offset;
  session.edit_property("move " + handle.name, {handle.path, brief_place(position)});
}

}  // namespace ps::gui
