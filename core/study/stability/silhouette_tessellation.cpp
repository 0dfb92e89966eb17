#include <array>

#include <fmt/format.h>

#include "raster/tessellate.h"
#include "scene/generate/uv_sphere.h"
#include "study/stability/support.h"

namespace ps::stability {
namespace {

/// Largest distance (px) between the outline of a ball of triangles, seen along `axis`, and the circle that it stands
/// for, whose radius is `radius` px. The outline's vertices are those of the ring across the axis.
double outline_error(const Mesh& mesh, const Vec3d& axis, double radius) {
  const auto on_outline = [&](const Vec3d& p) { return std::abs(dot(p, axis)) < 1e-9 * std::sqrt(dot(p, p)); };
  double worst = 0;
  for (const MeshTriangle& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d &a = mesh.positions[triangle.position[k]], &b = mesh.positions[triangle.position[(k + 1) % 3]];
      if (!on_outline(a) || !on_outline(b)) continue;
      constexpr int steps = 100;
      for (int i = 0; i <= steps; ++i) {
        const Vec3d p = a + (b - a) * (static_cast<double>(i) / steps);
        worst = std::max(worst, radius * (1 - std::sqrt(dot(p, p) / dot(a, a))));
      }
    }
  return worst;
}

/// A ball of this many segments around.
double error_of_segments(int segments, double radius) {
  return outline_error(make_uv_sphere({segments, 4}), {0, 1, 0}, radius);
}

/// What the option `tessellation` makes of a sphere in an orthographic picture.
struct Tessellated {
  double error = 0;  ///< px
  int segments = 0;
};
Tessellated tessellated(double allowed, double radius) {
  raster::TessellationView view;
  view.projection = Projection::orthographic;
  view.pixels_per_unit = 1;
  view.max_error = allowed;
  const Mesh mesh = raster::tessellate_sphere(Sphere{Vec3d(0), radius}, view);
  Tessellated result{outline_error(mesh, view.forward, radius), 0};
  for (const Vec3d& p : mesh.positions) result.segments += std::abs(dot(p, view.forward)) < 1e-9 * radius ? 1 : 0;
  return result;
}

std::vector<StabilityRow> measure_silhouette(const StabilityRun& run) {
  Rows rows(run);
  const std::string unit = "px off the circle";
  for (const int radius : {10, 50, 100, 200, 500, 1000}) {
    const double robust = tessellated(0.5, radius).error;
    for (const int segments : {10, 20, 45, 100})
      rows.push_back({static_cast<double>(segments), fmt::format("radius {} px", radius),
                      error_of_segments(segments, radius), robust, unit});
    const int enough = static_cast<int>(std::ceil(pi / std::acos(1 - 0.5 / radius)));
    rows.push_back({static_cast<double>(enough), fmt::format("enough for radius {} px", radius),
                    error_of_segments(enough, radius), robust, unit});
  }
  for (const double allowed : {10.0, 2.0, 0.5, 0.1}) {
    const Tessellated mesh = tessellated(allowed, 200);
    rows.push_back({static_cast<double>(mesh.segments), fmt::format("radius 200 px, tessellation = {} px", allowed),
                    mesh.error, tessellated(0.5, 200).error, unit});
  }
  return rows;
}

/// A sphere made of about this many segments: half of the error that `tessellation` allows is for the outline.
StabilityPicture picture_silhouette(double segments) {
  constexpr double radius = 0.45;
  StabilityPicture picture{.scene = fmt::format(R"(
viewport_size = 1 x 1
projection_plane_d = 1
background = white
sphere {{ center = (0, 0, 2)  radius = {}  color = (220, 60, 40) }}
light {{ type = ambient  intensity = 0.3 }}
light {{ type = directional  intensity = 0.7  direction = (1, 1, -1) }}
)",
                                                2 * radius)};
  picture.robust.renderer = Renderer::rasterizer;
  picture.naive = picture.robust;
  picture.naive.tessellation = 2 * radius * picture.height * (1 - std::cos(pi / segments));
  return picture;
}

constexpr std::array segments{6.0, 10.0, 20.0, 45.0};

}  // namespace

const StabilityExperiment silhouette_tessellation{
    .key = "silhouette-tessellation",
    .title = "Polygonal outlines of spheres",
    .knob = "segments of the outline",
    .naive = "the same number of segments at any size",
    .robust = "as many as keep within half a pixel (tessellation = 0.5)",
    .explanation =
        "A chord leaves its circle by R (1 - cos(pi / n)), which grows with the radius R on the screen. So the number "
        "of segments has to follow from the size: pi / acos(1 - 0.5 / R) for half a pixel.",
    .safe = "100 segments up to a radius of 1,000 pixels.",
    .window = {100, everywhere},
    .measure = measure_silhouette,
    .picture = picture_silhouette,
    .frames = segments};

}  // namespace ps::stability
