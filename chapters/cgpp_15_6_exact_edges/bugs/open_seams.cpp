// There are gaps along the edges where triangles meet.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgpp_15_6_exact_edges {
namespace {

// A place in whole steps of 1/2^bits of a pixel: sums and products of its coordinates are exact.
struct Point {
  std::int64_t x = 0, y = 0;
};

Point snap(const Vec2d& p, std::int64_t steps) {
  const auto scale = static_cast<double>(steps);
  return {std::llrint(p.x * scale), std::llrint(p.y * scale)};
}

// Twice the area of the triangle a, b, p: positive where p lies on the left of the way from a to b.
std::int64_t edge(const Point& a, const Point& b, const Point& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

// The vertices go round to the left, so the inside is on the left of each edge. A left edge then goes down, and a
// top edge goes to the left.
bool is_top_or_left(const Point& a, const Point& b) {
  const bool left = b.y < a.y;
  const bool top = b.y == a.y && b.x < a.x;
  return left && top;
}

// A sample on an edge belongs to the triangle only if it owns this edge.
bool covers(std::int64_t value, bool owned) { return owned ? value >= 0 : value > 0; }

void fill_triangle(BookCanvas& canvas, std::array<Point, 3> v, std::int64_t steps, bool all_owned,
                   const CanvasTriangle& triangle) {
  if (edge(v[0], v[1], v[2]) < 0) std::swap(v[1], v[2]);
  const std::int64_t area = edge(v[0], v[1], v[2]);
  PS_WATCH("twice the area", area);
  if (area == 0) return;
  std::array<bool, 3> owned{};
  for (std::size_t i = 0; i < 3; ++i) owned[i] = all_owned || is_top_or_left(v[(i + 1) % 3], v[(i + 2) % 3]);

  // The first and the last column and row in which a sample may be covered.
  const auto [x_low, x_high] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [y_low, y_high] = std::minmax({v[0].y, v[1].y, v[2].y});
  const auto column = [&](std::int64_t x) { return static_cast<int>(x / steps); };
  const int left = std::max(canvas.left(), column(x_low) - 1), right = std::min(canvas.right() - 1, column(x_high) + 1);
  const int low = std::max(canvas.bottom(), column(y_low) - 1), high = std::min(canvas.top() - 1, column(y_high) + 1);
  for (int y = low; y <= high; ++y) {
    for (int x = left; x <= right; ++x) {
      PS_PIXEL(x, y);
      const Point sample{x * steps, y * steps};
      bool inside = true;
      for (std::size_t i = 0; i < 3; ++i) {
        PS_EACH("edge opposite vertex", i);
        const std::int64_t value = edge(v[(i + 1) % 3], v[(i + 2) % 3], sample);
        PS_WATCH("edge function", value);
        PS_WATCH("a top or left edge", owned[i]);
        inside = inside && covers(value, owned[i]);
      }
      PS_WATCH("covered", inside);
      if (!inside) continue;
      const Vec3d mix = blended(triangle.blend, canvas.get_pixel(x, y), triangle.colours[0] * 255.0);
      PS_WATCH("canvas becomes", mix);
      canvas.put_pixel(x, y, mix);
    }
  }
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const std::int64_t steps = std::int64_t{1} << scene.settings.subpixel_bits;  // in a pixel
  const bool all_owned = scene.settings.fill_rule == FillRule::inclusive;
  for (const CanvasItem& item : lines_and_triangles(*scene.scene.canvas_items)) {
    const auto* triangle = std::get_if<CanvasTriangle>(&item);
    if (!triangle || !triangle->filled) continue;
    const auto& p = triangle->points;
    if (canvas.far_outside(p[0]) || canvas.far_outside(p[1]) || canvas.far_outside(p[2])) continue;
    PS_REACHING("triangle with vertex", p[0]);
    fill_triangle(canvas, {snap(p[0], steps), snap(p[1], steps), snap(p[2], steps)}, steps, all_owned, *triangle);
  }
}

}  // namespace
}  // namespace cgpp_15_6_exact_edges

namespace textbook {
extern const Listing cgpp_15_6_exact_edges;
const Listing cgpp_15_6_exact_edges{
    .label = "exact edges",
    .source = "CGPP 15.6.4",
    .shows = "Triangles on the canvas, without outlines, filled where three edge functions in whole numbers say so.",
    .order = ListingOrder::object_by_object,
    .reads = {"subpixel-bits", "fill-rule"},
    .draws = {.canvas_triangles = true},
    .as_settings = [](Settings& settings) { settings.canvas_fill = CanvasFill::edges; },
    .suits = [](const SceneTraits& traits, const Settings&) { return traits.canvas_triangles ? 1 : 0; },
    .draw = ps::cgpp_15_6_exact_edges::draw,
};
}  // namespace textbook
}  // namespace ps
