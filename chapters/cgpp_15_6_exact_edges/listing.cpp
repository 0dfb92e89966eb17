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

// A place in whole steps of 1/2^bits of a pixel: sums and products
// of its coordinates are exact.
struct Point {
  std::int64_t x = 0, y = 0;
};

using Points = std::array<Point, 3>;

Point snap(const Vec2d& p, std::int64_t steps) {
  const auto scale = static_cast<double>(steps);
  return {std::llrint(p.x * scale), std::llrint(p.y * scale)};
}

// Twice the area of the triangle a, b, p: positive where p lies on
// the left of the way from a to b.
std::int64_t edge(Point a, Point b, Point p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

// The vertices go round to the left, so the inside is on the left
// of each edge. A left edge then goes down, a top edge to the left.
bool is_top_or_left(const Point& a, const Point& b) {
  const bool left = b.y < a.y;
  const bool top = b.y == a.y && b.x < a.x;
  return left || top;
}

// A sample on an edge belongs to the triangle only if it owns this
// edge.
bool covers(std::int64_t value, bool owned) {
  return owned ? value >= 0 : value > 0;
}

void fill_triangle(BookCanvas& canvas, Points v, std::int64_t steps,
                   bool all_owned, const CanvasTriangle& triangle) {
  if (edge(v[0], v[1], v[2]) < 0) std::swap(v[1], v[2]);
  const std::int64_t area = edge(v[0], v[1], v[2]);
  PS_WATCH("twice the area", area);
  if (area == 0) return;
  // Edge i is opposite vertex i.
  const Points from{v[1], v[2], v[0]}, to{v[2], v[0], v[1]};
  std::array<bool, 3> owned{};
  for (std::size_t i = 0; i < 3; ++i)
    owned[i] = all_owned || is_top_or_left(from[i], to[i]);

  // The columns and rows in which a sample may be covered.
  const auto [x_low, x_high] =
      std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [y_low, y_high] =
      std::minmax({v[0].y, v[1].y, v[2].y});
  const auto pixels = [&](std::int64_t length) {
    return static_cast<int>(length / steps);
  };
  const int x0 = std::max(canvas.left(), pixels(x_low) - 1);
  const int x1 = std::min(canvas.right() - 1, pixels(x_high) + 1);
  const int y0 = std::max(canvas.bottom(), pixels(y_low) - 1);
  const int y1 = std::min(canvas.top() - 1, pixels(y_high) + 1);
  const Vec3d colour = triangle.colours[0] * 255.0;
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      PS_PIXEL(x, y);
      const Point sample{x * steps, y * steps};
      bool inside = true;
      for (std::size_t i = 0; i < 3; ++i) {
        PS_EACH("edge opposite vertex", i);
        const std::int64_t value = edge(from[i], to[i], sample);
        PS_WATCH("edge function", value);
        PS_WATCH("a top or left edge", owned[i]);
        inside = inside && covers(value, owned[i]);
      }
      PS_WATCH("covered", inside);
      if (!inside) continue;
      const Vec3d below = canvas.get_pixel(x, y);
      const Vec3d mix = blended(triangle.blend, below, colour);
      PS_WATCH("canvas becomes", mix);
      canvas.put_pixel(x, y, mix);
    }
  }
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const Settings& settings = scene.settings;
  const bool all_owned = settings.fill_rule == FillRule::inclusive;
  // In a pixel.
  const std::int64_t steps = std::int64_t{1}
                             << settings.subpixel_bits;
  const auto items = lines_and_triangles(*scene.scene.canvas_items);
  for (const CanvasItem& item : items) {
    const auto* triangle = std::get_if<CanvasTriangle>(&item);
    if (!triangle || !triangle->filled) continue;
    Points v;
    bool far = false;
    for (std::size_t k = 0; k < 3; ++k) {
      far = far || canvas.far_outside(triangle->points[k]);
      if (!far) v[k] = snap(triangle->points[k], steps);
    }
    if (far) continue;
    PS_REACHING("triangle with vertex", triangle->points[0]);
    fill_triangle(canvas, v, steps, all_owned, *triangle);
  }
}

}  // namespace
}  // namespace cgpp_15_6_exact_edges

namespace textbook {
extern const Listing cgpp_15_6_exact_edges;
const Listing cgpp_15_6_exact_edges{
    .label = "exact edges",
    .source = "CGPP 15.6.4",
    .shows = "Triangles on the canvas, without outlines, filled "
             "where three edge functions in whole numbers say so.",
    .order = ListingOrder::object_by_object,
    .reads = {"subpixel-bits", "fill-rule"},
    .draws = {.canvas_triangles = true},
    .as_settings =
        [](Settings& settings) {
          settings.canvas_fill = CanvasFill::edges;
        },
    .suits =
        [](const SceneTraits& traits, const Settings&) {
          return traits.canvas_triangles ? 1 : 0;
        },
    .draw = ps::cgpp_15_6_exact_edges::draw,
};
}  // namespace textbook
}  // namespace ps
