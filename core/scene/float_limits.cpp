#include "scene/float_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <optional>
#include <variant>

#include <glm/matrix.hpp>

#include "base/stop.h"
#include "math/triangle_distance.h"
#include "scene/object_boxes.h"
#include "scene/working_space.h"
#include "scene/world.h"

namespace ps {
namespace {

constexpr double float_step = 0x1p-24;  ///< rounding, as a share of a number
constexpr double seen = 0x1p-10;        ///< the share of a size or a distance that is seen
constexpr double seen_in_pixel = 0x1p-4;
/// The rounding of a place after the products and sums of an interpolation, as a share of the largest number in it.
constexpr double interpolated_step = 0x1p-20;

using Corners = std::array<Vec3d, 3>;

/// From a point to the surface of a form. Both in the space of the form.
double distance_to_surface(const FormFrame& form, const Vec3d& point) {
  const Vec3d from = point - form.centre;
  const Vec3d p{dot(form.axes[0], from), dot(form.axes[1], from), dot(form.axes[2], from)};
  const auto of_walls = [](const Vec3d& beyond) {  // signed distances from the walls of something convex
    const double nearest = std::max({beyond.x, beyond.y, beyond.z});
    return nearest > 0 ? length_of(glm::max(beyond, Vec3d(0))) : -nearest;
  };
  switch (form.kind) {
  case FormKind::ball:
    return std::abs(length_of(p) - form.half.x);
  case FormKind::plane:
    return std::abs(p.z);
  case FormKind::rectangle:
    return length_of(Vec3d{std::max({-p.x, p.x - form.half.x, 0.0}), std::max({-p.y, p.y - form.half.y, 0.0}), p.z});
  case FormKind::brick:
    return of_walls(glm::abs(p) - form.half);
  case FormKind::cylinder:
    return of_walls({length_of(Vec3d{p.x, p.y, 0}) - form.half.x, -p.z, p.z - form.half.z});
  }
  return 0;
}

class FloatSearch {
 public:
  explicit FloatSearch(const Scene& scene)
      : scene_(scene), boxes_(boxes_of_objects(*scene.geometry)), eye_(scene.camera.position),
        space_(working_space(boxes_, eye_)) {
    const Camera& camera = scene.camera;
    pixel_ = camera.viewport_height / camera.projection_plane_d / scene.canvas_height;
    near_ = camera.projection_plane_d * 0x1p-6;
    least_seen_ = std::min(seen, seen_in_pixel * pixel_);
    eye_error_ = float_step * largest_component(eye_ - space_.origin);
    for (const Light& light : *scene.lights)
      if (light.kind == LightKind::point && light.intensity != 0) lamps_.push_back(light.position);
  }

  FloatLimits run() {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      check_stop();
      const Object& object = scene_.geometry->objects[i];
      look_at(boxes_[i]);
      if (const auto* instance = std::get_if<Instance>(&object.shape)) look_at(*instance, boxes_[i]);
      if (const auto* solid = std::get_if<Solid>(&object.shape)) look_at(*solid, boxes_[i]);
      if (const auto* sphere = std::get_if<Sphere>(&object.shape))
        for (const Vec3d& lamp : lamps_)
          note_lamp(std::abs(length_of(lamp - sphere->centre) - sphere->radius), reach_of(boxes_[i]));
    }
    return limits_;
  }

 private:
  double reach_of(const FormBox& box) const {
    return std::max(largest_component(box.low - space_.origin), largest_component(box.high - space_.origin));
  }

  /// An object as a whole.
  void look_at(const FormBox& box) {
    if (!is_bounded(box)) return;
    const double size = largest_component(box.high - box.low), distance = distance_to(box, eye_);
    if (distance > 0 && eye_error_ > seen * std::max(distance, near_)) limits_.detail = true;
    if (size > pixel_ * distance && std::max(float_step * reach_of(box), eye_error_) > seen * size && size > 0)
      limits_.detail = true;
  }

  void look_at(const Instance& instance, const FormBox& box) {
    if (!is_bounded(box)) return;
    const double reach = reach_of(box);
    // Farther away than this no triangle of it is seen to be rounded.
    const double most = float_step * reach / least_seen_;
    const bool near_eye = distance_to(box, eye_) < std::max(most, near_);
    std::vector<Vec3d> lamps;
    for (const Vec3d& lamp : lamps_)
      if (distance_to(box, lamp) <= interpolated_step * reach) lamps.push_back(lamp);
    if (!near_eye && lamps.empty()) return;
    const Mesh& mesh = *scene_.geometry->meshes.at(instance.mesh);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (i % 4096 == 4095) check_stop();
      Corners corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = to_world(instance.transform, mesh.positions[mesh.triangles[i].position[k]]);
      if (near_eye) look_at(corners);
      for (const Vec3d& lamp : lamps) note_lamp(distance_to_triangle(lamp, corners[0], corners[1], corners[2]), reach);
    }
  }

  void look_at(const Corners& corners) {
    FormBox box;
    for (const Vec3d& corner : corners) include_point(box, corner);
    const double size = largest_component(box.high - box.low), error = float_step * reach_of(box);
    if (!(error > least_seen_ * distance_to(box, eye_))) return;
    const double distance = distance_to_triangle(eye_, corners[0], corners[1], corners[2]);
    if (error > seen * std::max(distance, near_)) limits_.places = true;
    if (size > pixel_ * distance && error > std::max(seen * size, seen_in_pixel * pixel_ * distance))
      limits_.detail = true;
  }

  void look_at(const Solid& solid, const FormBox& box) {
    const FormFrame form = form_frame(solid.form);
    const bool flat = form.kind == FormKind::rectangle;
    const Mat3d back = glm::inverse(solid.place.linear);
    const auto distance = [&](const Vec3d& point) {
      return distance_to_surface(form, back * (point - solid.place.translation));
    };
    const double reach = reach_of(box), stretch = largest_component(back * Vec3d(1));
    // Curved solids and planes have triangles that suit the view.
    if ((flat || form.kind == FormKind::brick) &&
        float_step * reach * stretch > seen * std::max(distance(eye_), near_ * stretch))
      limits_.places = true;
    for (const Vec3d& lamp : lamps_) note_lamp(distance(lamp), reach * stretch);
  }

  void note_lamp(double distance, double reach) {
    if (distance <= interpolated_step * reach) limits_.light_at_surface = true;
  }

  const Scene& scene_;
  const std::vector<FormBox> boxes_;
  const Vec3d eye_;
  const WorkingSpace space_;
  double pixel_ = 0;  ///< the height of one, at distance 1
  double near_ = 0, eye_error_ = 0;
  double least_seen_ = 0;  ///< of an error, as a share of its distance
  std::vector<Vec3d> lamps_;
  FloatLimits limits_;
};

/// Limits that were found, with all that they follow from.
struct KeptLimits {
  std::uint64_t geometry = 0, lights = 0;  // revisions
  Camera camera;
  int canvas_height = 0;
  FloatLimits limits;
};

}  // namespace

FloatLimits float_limits(const Scene& scene) {
  if (scene.geometry->objects.empty()) return {};
  // They are asked for with each picture, story and edit, and a million objects take 20 ms to search.
  static std::mutex mutex;
  static std::array<std::optional<KeptLimits>, 8> kept;
  static std::size_t oldest = 0;
  {
    const std::lock_guard lock(mutex);
    for (const auto& each : kept)
      if (each && each->geometry == scene.geometry.revision() && each->lights == scene.lights.revision() &&
          each->camera == scene.camera && each->canvas_height == scene.canvas_height)
        return each->limits;
  }
  const FloatLimits limits = FloatSearch(scene).run();
  const std::lock_guard lock(mutex);
  kept[oldest++ % kept.size()] =
      KeptLimits{scene.geometry.revision(), scene.lights.revision(), scene.camera, scene.canvas_height, limits};
  return limits;
}

}  // namespace ps
