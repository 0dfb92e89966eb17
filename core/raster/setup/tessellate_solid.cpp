#include "raster/setup/tessellate_solid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/check.h"
#include "math/has_nan.h"
#include "math/portable.h"
#include "math/unit.h"
#include "scene/form_frame.h"
#include "scene/uv_maps.h"

namespace ps::raster {
namespace {

using std::numbers::pi;
constexpr int plane_segments = 32;
constexpr double ring_growth = 2;
constexpr int min_segments = 8, max_segments = 512;

struct Corner {
  Vec3d position;
  Vec3d normal;
  Vec2d uv;
};

class Builder {
 public:
  std::uint32_t corner(const Corner& corner) {
    mesh_.positions.push_back(corner.position);
    mesh_.normals.push_back(corner.normal);
    mesh_.uvs.push_back(corner.uv);
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    MeshTriangle t;
    t.position = {a, b, c};
    for (std::size_t k = 0; k < 3; ++k) t.normal[k] = t.uv[k] = static_cast<std::int32_t>(t.position[k]);
    mesh_.triangles.push_back(t);
  }
  /// Vertices in order around the front.
  void quad(const std::array<Corner, 4>& corners) {
    const auto a = corner(corners[0]), b = corner(corners[1]), c = corner(corners[2]), d = corner(corners[3]);
    triangle(a, b, c);
    triangle(a, c, d);
  }
  /// All triangles once more, seen from the other side.
  void add_back() {
    const auto count = static_cast<std::uint32_t>(mesh_.positions.size());
    for (std::uint32_t i = 0; i < count; ++i) corner({mesh_.positions[i], -mesh_.normals[i], mesh_.uvs[i]});
    const std::size_t triangles = mesh_.triangles.size();
    for (std::size_t i = 0; i < triangles; ++i) {
      const auto p = mesh_.triangles[i].position;
      triangle(p[0] + count, p[2] + count, p[1] + count);
    }
  }
  Mesh take() { return std::move(mesh_); }

 private:
  Mesh mesh_;
};

void build_rectangle(const FormFrame& f, Builder& builder) {
  const Vec3d a = f.axes[0] * f.half.x, b = f.axes[1] * f.half.y, n = f.axes[2];
  builder.quad({Corner{f.centre, n, {0, 1}},
                {f.centre + a, n, {1, 1}},
                {f.centre + a + b, n, {1, 0}},
                {f.centre + b, n, {0, 0}}});
}

/// The radii of a plane's rings around the point below the eye.
std::vector<double> plane_rings(const FormFrame& f, const TessellationView& view) {
  // A quarter of it, the first ring, must not round to 0: it would never grow.
  constexpr double least = 1e-300;
  const double first = std::max({std::abs(dot(view.eye - f.centre, f.axes[2])), view.nearest, least});
  const double widest = 2 * first * std::max(view.pixels_per_unit, 16.0);
  std::vector<double> radii{first / 4};
  while (radii.back() < widest) radii.push_back(radii.back() * ring_growth);
  return radii;
}

void build_plane(const FormFrame& f, const TessellationView& view, Builder& builder) {
  const Vec3d& n = f.axes[2];
  const Vec3d below = view.eye - n * dot(view.eye - f.centre, n);
  const auto corner = [&](double radius, int segment) {
    const double turn = 2 * pi * segment / plane_segments;
    const Vec3d position = below + (f.axes[0] * portable::cos(turn) + f.axes[1] * portable::sin(turn)) * radius;
    const Vec3d offset = position - f.centre;
    return builder.corner({position, n, {dot(offset, f.axes[0]), -dot(offset, f.axes[1])}});
  };
  const std::uint32_t middle = corner(0, 0);
  std::uint32_t inner = 0;
  bool fan = true;
  for (const double radius : plane_rings(f, view)) {
    std::uint32_t outer = 0;
    for (int i = 0; i < plane_segments; ++i) {
      const std::uint32_t index = corner(radius, i);
      if (i == 0) outer = index;
    }
    for (std::uint32_t i = 0; i < plane_segments; ++i) {
      const std::uint32_t next = (i + 1) % plane_segments;
      if (fan) {
        builder.triangle(middle, outer + i, outer + next);
      } else {
        builder.triangle(inner + i, outer + i, outer + next);
        builder.triangle(inner + i, outer + next, inner + next);
      }
    }
    inner = outer;
    fan = false;
  }
}

void build_brick(const FormFrame& f, Builder& builder) {
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double side = face % 2 == 0 ? -1 : 1;
    const auto corner = [&](double a, double b) {
      Vec3d p(0);
      p[axis] = side;
      p[u] = a * side;  // keeps the order of vertices around the outside
      p[v] = b;
      const Vec3d world =
          f.centre + f.axes[0] * (p.x * f.half.x) + f.axes[1] * (p.y * f.half.y) + f.axes[2] * (p.z * f.half.z);
      return Corner{world, f.axes[static_cast<std::size_t>(axis)] * side, cube_cross_uv(face, p)};
    };
    builder.quad({corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)});
  }
}

/// Segments whose chords stray from the circle by at most max_error pixels at the nearest point of the cylinder.
int cylinder_segments(const FormFrame& f, const TessellationView& view) {
  double distance = 1;
  if (view.projection == Projection::perspective) {
    const Vec3d middle = f.centre + f.axes[2] * (f.half.z / 2);
    const Vec3d offset = view.eye - middle;
    distance = std::max(length_of(offset) - std::sqrt(f.half.x * f.half.x + f.half.z * f.half.z / 4), view.nearest);
  }
  const double sag = view.max_error / view.pixels_per_unit * distance / f.half.x;
  const double half_angle = portable::acos(std::max(1 - sag, 0.0));
  return static_cast<int>(
      std::clamp(std::ceil(pi / std::max(half_angle, 1e-6)), double(min_segments), double(max_segments)));
}

void build_cylinder(const FormFrame& f, const TessellationView& view, Builder& builder) {
  const int segments = cylinder_segments(f, view);
  const Vec3d up = f.axes[2] * f.half.z;
  const auto out = [&](int i) {
    const double turn = 2 * pi * i / segments - pi;
    return f.axes[0] * portable::cos(turn) + f.axes[1] * portable::sin(turn);
  };
  const auto cap_uv = [&](int face, const Vec3d& o) {
    return cylinder_uv(face, Vec3d{dot(o, f.axes[0]), dot(o, f.axes[1]), 0});
  };
  const std::uint32_t low = builder.corner({f.centre, -f.axes[2], cap_uv(0, Vec3d(0))});
  const std::uint32_t high = builder.corner({f.centre + up, f.axes[2], cap_uv(1, Vec3d(0))});
  for (int i = 0; i < segments; ++i) {
    const Vec3d a = out(i), b = out(i + 1);
    const Vec3d pa = f.centre + a * f.half.x, pb = f.centre + b * f.half.x;
    const double ua = double(i) / segments, ub = double(i + 1) / segments;
    builder.quad({Corner{pa, a, {ua, 1}}, {pb, b, {ub, 1}}, {pb + up, b, {ub, 0}}, {pa + up, a, {ua, 0}}});
    const auto low_a = builder.corner({pa, -f.axes[2], cap_uv(0, a)}),
               low_b = builder.corner({pb, -f.axes[2], cap_uv(0, b)});
    builder.triangle(low, low_b, low_a);
    const auto high_a = builder.corner({pa + up, f.axes[2], cap_uv(1, a)}),
               high_b = builder.corner({pb + up, f.axes[2], cap_uv(1, b)});
    builder.triangle(high, high_a, high_b);
  }
}

/// The loops below end for finite numbers alone.
void require_finite(const FormFrame& f, const TessellationView& view) {
  const bool frame = is_finite(f.centre) && is_finite(f.half) &&
                     std::all_of(f.axes.begin(), f.axes.end(), [](const Vec3d& axis) { return is_finite(axis); });
  if (!frame || !is_finite(view.eye) || !std::isfinite(view.pixels_per_unit) || !std::isfinite(view.nearest))
    throw InputError("a shape with a position or size that is not finite cannot be tessellated");
}

}  // namespace

Mesh tessellate_solid(const Solid& solid, const TessellationView& view) {
  const FormFrame frame = form_frame(solid.form);
  require_finite(frame, view);
  Builder builder;
  switch (frame.kind) {
  case FormKind::ball:
    return tessellate_sphere({frame.centre, frame.half.x, solid.material}, view);
  case FormKind::plane:
    build_plane(frame, view, builder);
    break;
  case FormKind::rectangle:
    build_rectangle(frame, builder);
    break;
  case FormKind::brick:
    build_brick(frame, builder);
    break;
  case FormKind::cylinder:
    build_cylinder(frame, view, builder);
    break;
  }
  if (is_flat(solid.form) && solid.sides == Sides::two) builder.add_back();
  return builder.take();
}

std::uint64_t solid_triangles(const Solid& solid, const TessellationView& view) {
  const FormFrame frame = form_frame(solid.form);
  require_finite(frame, view);
  const std::uint64_t faces = is_flat(solid.form) && solid.sides == Sides::two ? 2 : 1;
  switch (frame.kind) {
  case FormKind::ball:
    return sphere_triangles({frame.centre, frame.half.x, solid.material}, view);
  case FormKind::plane:
    return faces * plane_segments * (2 * plane_rings(frame, view).size() - 1);
  case FormKind::rectangle:
    return faces * 2;
  case FormKind::brick:
    return 12;
  case FormKind::cylinder:
    return 4 * static_cast<std::uint64_t>(cylinder_segments(frame, view));
  }
  return 0;
}

void add_world_map_uvs(Mesh& mesh, const Vec3d& centre) {
  mesh.uvs.clear();
  for (MeshTriangle& triangle : mesh.triangles) {
    std::array<Vec2d, 3> uvs;
    double highest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d offset = mesh.positions[triangle.position[k]] - centre;
      uvs[k] = world_map_uv(unit_of(offset));
      highest = std::max(highest, uvs[k].x);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      if (highest - uvs[k].x > 0.5) uvs[k].x += 1;
      triangle.uv[k] = static_cast<std::int32_t>(mesh.uvs.size());
      mesh.uvs.push_back(uvs[k]);
    }
  }
}

}  // namespace ps::raster
