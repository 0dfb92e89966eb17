#include "raster/setup/tessellate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "math/portable.h"
#include "math/unit.h"

namespace ps::raster {
namespace {

using std::numbers::pi;
constexpr int min_sphere_segments = 6;
constexpr int max_sphere_segments = 512;
constexpr double max_ring_step = pi / 6;
constexpr int max_front_rings = 192;
/// A closed sphere whose far side is hidden may have this many triangles; beyond, only its visible cap is made.
constexpr int max_closed_triangles = 8000;

/// The sphere as seen from the eye: `axis` points from the centre towards it.
struct Outlook {
  double radius = 1;
  double eye_distance = 2;  ///< from the centre; infinite in orthographic pictures
  Vec3d axis{0, 0, -1};
  double horizon = pi / 2;  ///< angle from the axis to the outline, seen from the centre
  const TessellationView* view = nullptr;

  bool eye_inside() const { return eye_distance <= radius; }

  /// How far a triangle may stray from the sphere, in world units, around the ring at `angle` from the axis. Half of
  /// the whole error, since triangles stray along a ring and across it.
  double allowance(double angle) const {
    const double error = view->max_error / 2 / view->pixels_per_unit;
    if (view->projection == Projection::orthographic) return error;
    const double squared =
        eye_distance * eye_distance + radius * radius - 2 * eye_distance * radius * portable::cos(angle);
    return error * std::max(std::sqrt(std::max(squared, 0.0)), view->nearest);
  }
  /// Half the central angle whose chord strays by the allowance.
  double half_step(double angle) const { return portable::acos(std::max(1 - allowance(angle) / radius, -1.0)); }
};

Outlook look_at(const Sphere& sphere, const TessellationView& view) {
  Outlook outlook;
  outlook.view = &view;
  outlook.radius = sphere.radius;
  const Vec3d to_eye = view.eye - sphere.centre;
  outlook.eye_distance = length_of(to_eye);
  const bool orthographic = view.projection == Projection::orthographic;
  const Vec3d axis = orthographic || outlook.eye_distance == 0 ? -view.forward : to_eye;
  outlook.axis = unit_of(axis);
  if (!orthographic && !outlook.eye_inside()) outlook.horizon = portable::acos(sphere.radius / outlook.eye_distance);
  if (orthographic) outlook.eye_distance = INFINITY;
  return outlook;
}

/// Angles of the rings from next to the axis up to the horizon, which is the last.
std::vector<double> front_rings(const Outlook& outlook) {
  std::vector<double> rings;
  const double least = outlook.horizon / max_front_rings;
  for (double angle = 0; angle < outlook.horizon;) {
    const double step = std::clamp(2 * outlook.half_step(angle), least, std::max(max_ring_step, least));
    angle += step;
    if (angle > outlook.horizon - least / 2) angle = outlook.horizon;
    rings.push_back(angle);
  }
  return rings;
}

int ring_segments(const Outlook& outlook, const std::vector<double>& rings) {
  double segments = min_sphere_segments;
  for (const double angle : rings) {
    const double sine =
        portable::sin(std::min(outlook.half_step(angle), pi / 2)) / std::max(portable::sin(angle), 1e-12);
    segments = std::max(segments, pi / portable::asin(std::min(sine, 1.0)));
  }
  return static_cast<int>(std::ceil(std::min<double>(segments, max_sphere_segments)));
}

/// The rings from the first pole to the last one, or to the second pole.
struct Rings {
  std::vector<double> angles;  ///< from the axis
  int segments = 0;
  bool closed = false;

  std::uint64_t triangles() const {
    const std::uint64_t bands = std::max<std::size_t>(angles.size(), 1) - 1, fans = closed ? 2 : 1;
    return static_cast<std::uint64_t>(segments) * (2 * bands + fans);
  }
};

Rings rings_of(const Outlook& outlook) {
  Rings rings{front_rings(outlook)};
  rings.segments = ring_segments(outlook, rings.angles);
  const int front = static_cast<int>(rings.angles.size());
  const double back_angle = pi - outlook.horizon;
  const int back = std::min(std::max(2, static_cast<int>(std::ceil(front * back_angle / outlook.horizon))), 64);
  rings.closed = outlook.view->far_side == FarSide::seen || outlook.eye_inside() ||
                 2 * rings.segments * (front + back) <= max_closed_triangles;
  if (rings.closed)
    for (int i = 1; i < back; ++i) rings.angles.push_back(outlook.horizon + back_angle * i / back);
  return rings;
}

/// Two directions perpendicular to `axis` and to each other, so that side x other = axis.
void perpendicular(const Vec3d& axis, Vec3d& side, Vec3d& other) {
  const Vec3d helper = std::abs(axis.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  side = unit_of(cross(helper, axis));
  other = cross(axis, side);
}

class MeshBuilder {
 public:
  MeshBuilder(const Sphere& sphere, const Outlook& outlook, int segments)
      : sphere_(sphere), axis_(outlook.axis), segments_(segments) {
    perpendicular(axis_, side_, other_);
    pole(1);
  }

  /// Adds a ring and joins it to the one before it, or to the first pole.
  void ring(double angle) {
    const auto before = last_ring_;
    last_ring_ = size();
    for (int i = 0; i < segments_; ++i) {
      const double turn = 2 * pi * i / segments_;
      vertex(axis_ * portable::cos(angle) +
             (side_ * portable::cos(turn) + other_ * portable::sin(turn)) * portable::sin(angle));
    }
    for (int i = 0; i < segments_; ++i) {
      const auto a = last_ring_ + static_cast<std::uint32_t>(i);
      const auto b = last_ring_ + static_cast<std::uint32_t>((i + 1) % segments_);
      if (before == 0) {
        triangle(0, a, b);
      } else {
        const auto c = before + static_cast<std::uint32_t>(i);
        const auto d = before + static_cast<std::uint32_t>((i + 1) % segments_);
        triangle(c, a, b);
        triangle(c, b, d);
      }
    }
  }
  void close() {
    const auto far_pole = size();
    pole(-1);
    for (int i = 0; i < segments_; ++i)
      triangle(far_pole, last_ring_ + static_cast<std::uint32_t>((i + 1) % segments_),
               last_ring_ + static_cast<std::uint32_t>(i));
  }
  Mesh take() { return std::move(mesh_); }

 private:
  std::uint32_t size() const { return static_cast<std::uint32_t>(mesh_.positions.size()); }
  void pole(double side) { vertex(axis_ * side); }
  void vertex(const Vec3d& direction) {
    mesh_.positions.push_back(sphere_.centre + direction * sphere_.radius);
    mesh_.normals.push_back(direction);
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    MeshTriangle t;
    t.position = {a, b, c};
    t.normal = {static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), static_cast<std::int32_t>(c)};
    mesh_.triangles.push_back(t);
  }

  const Sphere& sphere_;
  Vec3d axis_;
  Vec3d side_{1, 0, 0}, other_{0, 1, 0};
  int segments_;
  std::uint32_t last_ring_ = 0;
  Mesh mesh_;
};

}  // namespace

TessellationView make_tessellation_view(const Camera& camera, const Viewport<double>& viewport, double near,
                                        double max_error) {
  const auto projection = make_canvas_projection<double>(viewport);
  TessellationView view;
  view.eye = camera.position;
  view.forward = camera.forward;
  view.projection = viewport.projection;
  view.pixels_per_unit = std::max(projection.scale.x, projection.scale.y);
  view.nearest = near * viewport.distance;
  view.max_error = max_error;
  if (viewport.projection == Projection::perspective) {  // away from the centre, the same angle takes more pixels
    const double tangent_x = projection.centre.x / projection.scale.x;
    const double tangent_y = projection.centre.y / projection.scale.y;
    view.pixels_per_unit *= 1 + tangent_x * tangent_x + tangent_y * tangent_y;
  }
  return view;
}

Mesh tessellate_sphere(const Sphere& sphere, const TessellationView& view) {
  const Outlook outlook = look_at(sphere, view);
  const Rings rings = rings_of(outlook);
  MeshBuilder builder(sphere, outlook, rings.segments);
  for (const double angle : rings.angles) builder.ring(angle);
  if (rings.closed) builder.close();
  return builder.take();
}

std::uint64_t sphere_triangles(const Sphere& sphere, const TessellationView& view) {
  return rings_of(look_at(sphere, view)).triangles();
}

}  // namespace ps::raster
