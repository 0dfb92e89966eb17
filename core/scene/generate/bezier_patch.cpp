#include "scene/generate/bezier_patch.h"

#include <map>

#include "base/check.h"
#include "math/unit.h"

namespace ps {
namespace {

using Weights = std::array<double, 4>;

double value(PatchParameter t) { return static_cast<double>(t.step) / t.steps; }
/// 1 - t, with the rounding that t has when counted from the other end.
double complement(PatchParameter t) { return static_cast<double>(t.steps - t.step) / t.steps; }

/// Bernstein polynomials of degree 3; reversing t reverses them exactly.
Weights bernstein(PatchParameter parameter) {
  const double t = value(parameter), s = complement(parameter);
  return {s * s * s, 3 * (s * s * t), 3 * (t * t * s), t * t * t};
}

Weights bernstein_derivative(double t) {
  const double s = 1 - t;
  return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

Weights bernstein_second_derivative(double t) {
  const double s = 1 - t;
  return {6 * s, 6 * t - 12 * s, 6 * s - 12 * t, 6 * t};
}

Weights bernstein_at(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

/// Outer terms first, then the inner ones: the same sum from either end.
Vec3d blend(const Weights& w, const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  return (w[0] * a + w[3] * d) + (w[1] * b + w[2] * c);
}

Vec3d blend(const BezierPatch& patch, const Weights& u, const Weights& v) {
  const auto& p = patch.control;
  const auto row = [&](std::size_t first) { return blend(u, p[first], p[first + 1], p[first + 2], p[first + 3]); };
  return blend(v, row(0), row(4), row(8), row(12));
}

/// Leaves the very edge, where a derivative may vanish.
double inside(double t) {
  constexpr double margin = 0x1p-16;
  return t < margin ? margin : t > 1 - margin ? 1 - margin : t;
}

struct ByCoordinates {
  bool operator()(const Vec3d& a, const Vec3d& b) const {
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z < b.z;
  }
};

}  // namespace

Vec3d patch_point(const BezierPatch& patch, PatchParameter u, PatchParameter v) {
  const auto& p = patch.control;
  const Weights weights = bernstein(u);
  // A row that is a single point stays that point; the sum of its weighted copies would be rounded.
  const auto row = [&](std::size_t i) {
    const bool single = p[i] == p[i + 1] && p[i] == p[i + 2] && p[i] == p[i + 3];
    return single ? p[i] : blend(weights, p[i], p[i + 1], p[i + 2], p[i + 3]);
  };
  return blend(bernstein(v), row(0), row(4), row(8), row(12));
}

Vec3d patch_normal(const BezierPatch& patch, PatchParameter u, PatchParameter v) {
  const auto normal_at = [&](double s, double t) {
    return cross(blend(patch, bernstein_derivative(s), bernstein_at(t)),
                 blend(patch, bernstein_at(s), bernstein_derivative(t)));
  };
  Vec3d normal = normal_at(value(u), value(v));
  if (dot(normal, normal) < 1e-20) normal = normal_at(inside(value(u)), inside(value(v)));
  return unit_of(normal);
}

PatchBend patch_bend(const BezierPatch& patch, PatchParameter u, PatchParameter v) {
  const double s = value(u), t = value(v);
  const Vec3d normal = patch_normal(patch, u, v);
  const auto along_normal = [&](const Weights& a, const Weights& b) { return dot(normal, blend(patch, a, b)); };
  PatchBend bend;
  bend.point = patch_point(patch, u, v);
  bend.uu = along_normal(bernstein_second_derivative(s), bernstein_at(t));
  bend.uv = along_normal(bernstein_derivative(s), bernstein_derivative(t));
  bend.vv = along_normal(bernstein_at(s), bernstein_second_derivative(t));
  return bend;
}

Mesh tessellate(const std::vector<BezierPatch>& patches, int divisions) {
  PS_ASSERT(divisions >= 1, "a patch needs at least one division");
  const int n = divisions;
  Mesh mesh;
  mesh.materials = {0};
  std::map<Vec3d, std::uint32_t, ByCoordinates> known;
  for (const BezierPatch& patch : patches) {
    const auto first = static_cast<int>(mesh.normals.size());
    std::vector<std::uint32_t> vertices;
    for (int row = 0; row <= n; ++row) {
      for (int column = 0; column <= n; ++column) {
        const PatchParameter u{column, n}, v{row, n};
        const Vec3d point = patch_point(patch, u, v);
        const auto [place, is_new] = known.try_emplace(point, static_cast<std::uint32_t>(mesh.positions.size()));
        if (is_new) mesh.positions.push_back(point);
        vertices.push_back(place->second);
        mesh.normals.push_back(patch_normal(patch, u, v));
        mesh.uvs.push_back({value(u), value(v)});
      }
    }
    const auto add = [&](int a, int b, int c) {
      MeshTriangle triangle;
      const std::array<int, 3> corners{a, b, c};
      for (std::size_t k = 0; k < 3; ++k) {
        triangle.position[k] = vertices[static_cast<std::size_t>(corners[k])];
        triangle.normal[k] = triangle.uv[k] = first + corners[k];
      }
      const auto& p = triangle.position;
      if (p[0] != p[1] && p[1] != p[2] && p[2] != p[0]) mesh.triangles.push_back(triangle);
    };
    for (int row = 0; row < n; ++row) {
      for (int column = 0; column < n; ++column) {
        const int a = row * (n + 1) + column, b = a + 1, c = b + n + 1, d = a + n + 1;
        add(a, b, c);
        add(a, c, d);
      }
    }
  }
  return mesh;
}

}  // namespace ps
