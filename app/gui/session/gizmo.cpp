#include "gui/session/gizmo.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "gui/session/gizmo_shapes.h"
#include "gui/session/handles.h"
#include "render/story/names.h"

namespace ps::gui {
namespace {

constexpr double least_factor = 0.05, greatest_factor = 20;  // of one drag
constexpr double edge_on = 0.2;          // a ring whose plane faces the eye less is seen from the side
constexpr double least_crossing = 1e-3;  // squared sine between a line of sight and an axis

struct Line {
  Vec3d from, along;  ///< `along` has length 1
};

Line line_of_sight(const Sight& sight, const Vec2d& place) {
  const Camera& camera = sight.view.camera;
  const Vec3d near = position_at(sight.view, sight.settings, camera.position + camera.forward, place);
  const Vec3d far = position_at(sight.view, sight.settings, camera.position + camera.forward * 2.0, place);
  return {near, glm::normalize(far - near)};
}

/// Where along the axis, from the gizmo's centre, a line of sight comes nearest to it.
std::optional<double> along_axis(const GizmoDrag& drag, const Vec2d& place) {
  const Vec3d axis = drag.gizmo.axes[drag.part.axis];
  const Line line = line_of_sight(drag.sight, place);
  const Vec3d offset = drag.gizmo.centre - line.from;
  const double cosine = dot(axis, line.along), crossing = 1 - cosine * cosine;
  if (crossing < least_crossing) return {};
  const double at = (cosine * dot(line.along, offset) - dot(axis, offset)) / crossing;
  // Beyond the vanishing point of the axis the nearest point lies behind the eye.
  if (!place_in_picture(drag.sight.view, drag.sight.settings, drag.gizmo.centre + axis * at)) return {};
  return at;
}

/// The vector from the centre to where a line of sight meets the plane of the ring.
std::optional<Vec3d> on_ring(const GizmoDrag& drag, const Vec2d& place) {
  const Vec3d axis = drag.gizmo.axes[drag.part.axis];
  const Line line = line_of_sight(drag.sight, place);
  const double slope = dot(line.along, axis);
  if (std::abs(slope) < 1e-6) return {};
  return line.from + line.along * (dot(drag.gizmo.centre - line.from, axis) / slope) - drag.gizmo.centre;
}

std::optional<double> turned_by(const GizmoDrag& drag, const Vec2d& to) {
  const auto centre = place_in_picture(drag.sight.view, drag.sight.settings, drag.gizmo.centre);
  if (!centre) return {};
  const Vec3d axis = drag.gizmo.axes[drag.part.axis];
  const Vec3d sight = line_of_sight(drag.sight, *centre).along;
  if (std::abs(dot(sight, axis)) >= edge_on) {
    const auto a = on_ring(drag, drag.from), b = on_ring(drag, to);
    if (!a || !b) return {};
    return std::atan2(dot(axis, cross(*a, *b)), dot(*a, *b));
  }
  // From the side the ring is nearly a line: what counts is the way along its part that is next to the eye.
  const Vec3d tangent = glm::normalize(cross(axis, -sight));
  const auto beside = place_in_picture(drag.sight.view, drag.sight.settings, drag.gizmo.centre + tangent * drag.reach);
  if (!beside) return {};
  const Vec2d way = *beside - *centre;
  const double square = glm::dot(way, way);
  if (!(square > 0)) return {};
  return glm::dot(to - drag.from, way) / square;
}

}  // namespace

std::string_view deed_word(GizmoDeed deed) {
  switch (deed) {
  case GizmoDeed::move:
    return "move";
  case GizmoDeed::turn:
    return "turn";
  case GizmoDeed::scale:
    return "scale";
  }
  return {};
}

std::optional<Gizmo> gizmo_of(const Scene& scene, std::size_t object) {
  if (object >= scene.geometry->objects.size()) return {};
  Gizmo gizmo;
  gizmo.object = object;
  gizmo.name = object_name(scene, static_cast<int>(object));
  if (!place_gizmo(scene, object, gizmo)) return {};
  return gizmo;
}

Gizmo gizmo_of(const Camera& camera) {
  Gizmo gizmo;
  gizmo.name = "the camera";
  gizmo.centre = camera.position;
  gizmo.axes = {glm::normalize(camera.right), glm::normalize(camera.up), glm::normalize(camera.forward)};
  gizmo.turns = true;
  return gizmo;
}

std::optional<double> world_length(const Sight& sight, const Vec3d& at, double pixels) {
  const auto place = place_in_picture(sight.view, sight.settings, at);
  if (!place) return {};
  const Vec3d beside = position_at(sight.view, sight.settings, at, *place + Vec2d(pixels, 0));
  return glm::length(beside - at);
}

std::optional<double> gizmo_travel(const GizmoDrag& drag, const Vec2d& to) {
  if (drag.part.deed == GizmoDeed::turn) return turned_by(drag, to);
  const auto before = along_axis(drag, drag.from), after = along_axis(drag, to);
  if (!before || !after) return {};
  if (drag.part.deed == GizmoDeed::move) return *after - *before;
  if (!(std::abs(*before) > 0)) return {};
  return std::clamp(*after / *before, least_factor, greatest_factor);
}

Camera dragged_camera(const GizmoDrag& drag, double travel) {
  Camera camera = drag.camera;
  const Vec3d axis = drag.gizmo.axes[drag.part.axis];
  switch (drag.part.deed) {
  case GizmoDeed::move:
    camera.position += axis * travel;
    break;
  case GizmoDeed::turn: {
    const Mat3d by(glm::rotate(Mat4d(1.0), travel, axis));
    camera.right = by * camera.right;
    camera.up = by * camera.up;
    camera.forward = by * camera.forward;
    break;
  }
  case GizmoDeed::scale:
    break;
  }
  return camera;
}

void drag_gizmo(Session& session, const GizmoDrag& drag, const Vec2d& to) {
  const auto travel = gizmo_travel(drag, to);
  if (!travel || !std::isfinite(*travel)) return;
  session.edit(fmt::format("{} {}", deed_word(drag.part.deed), drag.gizmo.name), gizmo_step, [&](Document& document) {
    if (!drag.gizmo.object)
      document.view.camera = dragged_camera(drag, *travel);
    else
      for (const SceneEdit& edit : gizmo_edits(drag, *travel)) edit_scene(document, edit);
  });
}

}  // namespace ps::gui
