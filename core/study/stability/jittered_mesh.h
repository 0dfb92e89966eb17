#pragma once
#include <array>
#include <functional>

#include "image/image.h"
#include "raster/base/edge_function.h"
#include "study/stability/support.h"

namespace ps::stability {

/// A square of cells of two triangles each, whose inner vertices are moved at random: every inner edge is shared.
struct FlatMesh {
  std::vector<Vec2d> points;  ///< pixels
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::array<Vec2d, 3> corners(std::size_t i) const {
    return {points[triangles[i][0]], points[triangles[i][1]], points[triangles[i][2]]};
  }
};

/// `grid` is what positions are rounded to, in pixels; 0 = not at all. `jitter` is a share of a cell.
inline FlatMesh jittered_mesh(int cells, double first, double last, double jitter, double grid, Random& random) {
  FlatMesh mesh;
  const double size = (last - first) / cells;
  const auto place = [&](double v) { return grid > 0 ? std::round(v / grid) * grid : v; };
  for (int y = 0; y <= cells; ++y)
    for (int x = 0; x <= cells; ++x) {
      const bool inner = x > 0 && y > 0 && x < cells && y < cells;
      const double dx = random.between(-jitter, jitter) * size, dy = random.between(-jitter, jitter) * size;
      mesh.points.push_back({place(first + x * size + (inner ? dx : 0)), place(first + y * size + (inner ? dy : 0))});
    }
  const auto stride = static_cast<std::uint32_t>(cells + 1);
  for (std::uint32_t y = 0; y + 1 < stride; ++y)
    for (std::uint32_t x = 0; x + 1 < stride; ++x) {
      const std::uint32_t a = y * stride + x, b = a + 1, c = a + stride, d = c + 1;
      if ((x + y) % 2 != 0) {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({c, a, d});
      } else {
        mesh.triangles.push_back({b, c, a});
        mesh.triangles.push_back({c, b, d});
      }
    }
  return mesh;
}

/// The mesh turned about its centre by `angle` (radians) and rounded to `grid` pixels, 0 = not at all.
inline FlatMesh turned(FlatMesh mesh, const Vec2d& middle, double angle, double grid) {
  const double cosine = std::cos(angle), sine = std::sin(angle);
  const auto place = [&](double v) { return grid > 0 ? std::round(v / grid) * grid : v; };
  for (Vec2d& point : mesh.points) {
    const Vec2d p = point - middle;
    point = {place(middle.x + cosine * p.x - sine * p.y), place(middle.y + sine * p.x + cosine * p.y)};
  }
  return mesh;
}

/// Calls visit(edges, x, y) for each pixel of side x side in the box of a triangle whose vertices are rounded to this
/// number of fractional bits; for none if it has no area.
template <class Visit>
void for_pixels_in_box(const FlatMesh& mesh, std::size_t triangle, int bits, FillRule rule, int side, Visit&& visit) {
  const auto p = mesh.corners(triangle);
  const std::array corner{raster::to_fixed(p[0], bits), raster::to_fixed(p[1], bits), raster::to_fixed(p[2], bits)};
  const raster::CoverageGrid grid{bits, rule, {0.5, 0.5}};
  const auto edges = raster::make_edges(corner, grid);
  if (!edges) return;
  const TileRect box = raster::sample_box(corner, grid);
  for (int y = std::max(0, box.y0); y < std::min(side, box.y1); ++y)
    for (int x = std::max(0, box.x0); x < std::min(side, box.x1); ++x) visit(*edges, x, y);
}

/// Pixels covered by none and by several triangles.
struct Painted {
  double pixels = 0, holes = 0, doubles = 0;
};

/// Counts over the pixels [first, last) in both directions.
inline Painted count_painted(const Image<int>& times, int first, int last) {
  Painted painted;
  for (int y = first; y < last; ++y)
    for (int x = first; x < last; ++x) {
      const int n = times.at(x, y);
      ++painted.pixels;
      painted.holes += n == 0 ? 1 : 0;
      painted.doubles += n > 1 ? 1 : 0;
    }
  return painted;
}

}  // namespace ps::stability
