#include <algorithm>

#include <fmt/format.h>

#include "raster/setup/tessellate.h"
#include "study/stability/support.h"

namespace ps::stability::silhouette_tessellation {
namespace {

constexpr double half_a_pixel = 0.5;  ///< the default of the option `tessellation`

/// How far a chord of a regular polygon of n segments strays from its circle.
double chord_error(double radius, double segments) { return radius * (1 - std::cos(pi / segments)); }

/// The option `tessellation` with which the program makes an outline of that many segments: it leaves one half of the
/// error to the outline and the other to the rings across it.
double error_for(double radius, double segments) {
  constexpr double rounding = 1 + 1e-9;  // or one segment more is made
  return 2 * chord_error(radius, segments) * rounding;
}

double turn(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The convex hull, counterclockwise (Andrew's monotone chain); points within rounding of its edges are left out.
std::vector<Vec2d> convex_hull(std::vector<Vec2d> points) {
  std::sort(points.begin(), points.end(),
            [](const Vec2d& a, const Vec2d& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  constexpr double rounding = 1e-12;
  std::vector<Vec2d> hull;
  for (int way = 0; way < 2; ++way) {
    const std::size_t first = hull.size();
    for (const Vec2d& point : points) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= rounding) hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// The outline of a ball that is `radius` px large, in an orthographic picture, as the program cuts it into triangles.
struct Outline {
  double segments = 0;
  double deviation = 0;  ///< of the outline from the circle, px
};

Outline outline_of(double radius, double max_error) {
  raster::TessellationView view;
  view.projection = Projection::orthographic;
  view.pixels_per_unit = radius;
  view.max_error = max_error;
  const Mesh mesh = raster::tessellate_sphere({{0, 0, 0}, 1, 0}, view);
  std::vector<Vec2d> seen;
  for (const Vec3d& position : mesh.positions) seen.emplace_back(position.x, position.y);
  const std::vector<Vec2d> hull = convex_hull(std::move(seen));
  Outline outline{static_cast<double>(hull.size()), 0};
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2d &a = hull[i], &b = hull[(i + 1) % hull.size()];
    const double from_centre = turn({0, 0}, a, b) / std::hypot(b.x - a.x, b.y - a.y);
    outline.deviation = std::max(outline.deviation, radius * (1 - from_centre));
  }
  return outline;
}

void measure(const StabilityRun&, Rows& rows) {
  constexpr const char* unit = "px off the circle";
  for (const double radius : {10.0, 50.0, 100.0, 200.0, 500.0, 1000.0}) {
    const Outline program = outline_of(radius, half_a_pixel);
    for (const int segments : {10, 20, 45, 100}) {
      const Outline fixed = outline_of(radius, error_for(radius, segments));
      rows.add(fixed.segments, fmt::format("radius {} px", radius), fixed.deviation, program.deviation, unit);
      rows.add(fixed.segments, fmt::format("closed form: R (1 - cos(pi / n)), radius {} px", radius),
               chord_error(radius, segments), std::nan(""), unit);
    }
    const double enough = std::ceil(pi / std::acos(1 - half_a_pixel / radius));
    rows.add(radius, "segments for half a pixel, by radius: closed form beside the program's", enough, program.segments,
             "segments");
  }
}

/// A ball of 128 px in an orthographic picture.
StabilityPicture picture(double segments) {
  StabilityPicture picture{.scene = "viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = white\n"
                                    "sphere { center = (0, 0, 3) radius = 0.4 color = (180, 60, 50) }\n"
                                    "light { type = ambient intensity = 0.3 }\n"
                                    "light { type = directional intensity = 0.7 direction = (1, 2, -2) }\n",
                           .width = 160,
                           .height = 160};
  picture.robust.renderer = renderer_for(PictureWay::fragments);
  picture.robust.projection = Projection::orthographic;
  picture.naive = picture.robust;
  picture.naive.tessellation = error_for(64, segments);
  return picture;
}

}  // namespace

extern const StabilityExperiment silhouette_tessellation{
    .key = "silhouette-tessellation",
    .place = {Subject::shading, 50},
    .set_up = SetUp::reproduction,
    .title = "Silhouettes: polygonal outlines of round objects",
    .keywords = "silhouette, level of detail, LOD, polygon count, subdivision",
    .knob = "segments of the outline",
    .naive = "the same number of segments at any size",
    .robust = "as many as half a pixel of error asks for (tessellation = 0.5)",
    .explanation = "The distance between a chord and its circle is R (1 - cos(pi / n)), which grows with the radius on "
                   "the screen. The number of segments that are enough follows from that radius and the visible error.",
    .safe = "100 segments up to a radius of 1,000 pixels.",
    .window = {100, everywhere},
    .series = {{.names = "radius 100 px|radius*|*", .title = "distance of the outline from the circle", .unit = "px"},
               {.names = "segments for half a pixel*",
                .title = "segments that half a pixel of error asks for",
                .unit = "segments",
                .better = Better::neither,
                .knob = "radius of the ball (px)",
                .naive = "closed form",
                .robust = "the program's"}},
    .add_rows = measure,
    .picture = picture,
    .frames = {7.0, 10.0, 20.0, 45.0}};

}  // namespace ps::stability::silhouette_tessellation
