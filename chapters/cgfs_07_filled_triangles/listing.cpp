#include <array>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_07_filled_triangles {
namespace {

// Interpolate, of the chapter before.
std::vector<double> interpolate(double i0, double d0, double i1,
                                double d1) {
  if (i0 == i1) return {d0};
  std::vector<double> values;
  const double a = (d1 - d0) / (i1 - i0);
  double d = d0;
  for (double i = i0; i <= i1; ++i) {
    values.push_back(d);
    d += a;
  }
  return values;
}

// One pixel of a shape: paint covers what is below, light is added
// to it.
void mix_pixel(BookCanvas& canvas, double x, double y, Vec3d colour,
               Blend blend) {
  const Vec3d below = canvas.get_pixel(x, y);
  canvas.put_pixel(x, y, blended(blend, below, colour));
}

void draw_line(BookCanvas& canvas, Vec2d p0, Vec2d p1, Vec3d colour,
               Blend blend) {
  if (std::abs(p1.x - p0.x) > std::abs(p1.y - p0.y)) {
    if (p1.x < p0.x) std::swap(p0, p1);
    const auto ys = interpolate(p0.x, p0.y, p1.x, p1.y);
    for (double x = p0.x; x <= p1.x; ++x) {
      const double y = entry(ys, x, p0.x);
      PS_PIXEL(x, y);
      PS_WATCH("outline at", Vec2d(x, y));
      mix_pixel(canvas, x, y, colour, blend);
      PS_WATCH("canvas becomes", canvas.get_pixel(x, y));
    }
  } else {
    if (p1.y < p0.y) std::swap(p0, p1);
    const auto xs = interpolate(p0.y, p0.x, p1.y, p1.x);
    for (double y = p0.y; y <= p1.y; ++y) {
      const double x = entry(xs, y, p0.y);
      PS_PIXEL(x, y);
      PS_WATCH("outline at", Vec2d(x, y));
      mix_pixel(canvas, x, y, colour, blend);
      PS_WATCH("canvas becomes", canvas.get_pixel(x, y));
    }
  }
}

// Row by row, from the left edge to the right one, both ends
// included.
void draw_filled_triangle(BookCanvas& canvas, Vec2d p0, Vec2d p1,
                          Vec2d p2, Vec3d colour, Blend blend) {
  // Sorted by height, from below.
  if (p1.y < p0.y) std::swap(p1, p0);
  if (p2.y < p0.y) std::swap(p2, p0);
  if (p2.y < p1.y) std::swap(p2, p1);
  PS_WATCH("lowest vertex", p0);
  PS_WATCH("middle vertex", p1);
  PS_WATCH("highest vertex", p2);

  // x on each row. The long edge goes from the lowest vertex to the
  // highest one; the two short edges share the way.
  const auto x02 = interpolate(p0.y, p0.x, p2.y, p2.x);
  auto x012 = interpolate(p0.y, p0.x, p1.y, p1.x);
  const auto x12 = interpolate(p1.y, p1.x, p2.y, p2.x);
  x012.pop_back();  // the row of p1 is in both
  x012.insert(x012.end(), x12.begin(), x12.end());
  PS_WATCH("rows", x012.size());

  // Which is left shows in the middle.
  const std::size_t middle = x02.size() / 2;
  const bool long_is_left = x02[middle] < x012[middle];
  PS_WATCH("long edge is left", long_is_left);
  std::vector<double> x_left = x02, x_right = x012;
  if (!long_is_left) std::swap(x_left, x_right);

  for (double y = p0.y; y <= p2.y; ++y) {
    PS_REACHING("row", y);
    const double left = entry(x_left, y, p0.y);
    const double right = entry(x_right, y, p0.y);
    PS_WATCH("left, right", Vec2d(left, right));
    for (double x = left; x <= right; ++x) {
      PS_PIXEL(x, y);
      PS_WATCH("x", x);
      PS_WATCH("colour", colour);
      mix_pixel(canvas, x, y, colour, blend);
      PS_WATCH("canvas becomes", canvas.get_pixel(x, y));
    }
  }
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const auto items = lines_and_triangles(*scene.scene.canvas_items);
  for (const CanvasItem& item : items) {
    if (const auto* line = std::get_if<CanvasLine>(&item)) {
      const auto& [from, to] = line->points;
      if (canvas.far_outside(from) || canvas.far_outside(to))
        continue;
      PS_REACHING("line from", from);
      draw_line(canvas, from, to, line->colour * 255.0,
                line->blend);
      continue;
    }
    const auto& triangle = std::get<CanvasTriangle>(item);
    std::array<Vec2d, 3> p = triangle.points;
    bool far = false;
    for (Vec2d& vertex : p) {
      far = far || canvas.far_outside(vertex);
      // Rows are whole numbers.
      vertex = {std::trunc(vertex.x), std::trunc(vertex.y)};
    }
    if (far) continue;
    PS_REACHING("triangle with vertex", p[0]);
    const Blend blend = triangle.blend;
    const Vec3d colour = triangle.colours[0] * 255.0;
    if (triangle.filled)
      draw_filled_triangle(canvas, p[0], p[1], p[2], colour, blend);
    if (triangle.outline) {
      const Vec3d outline = *triangle.outline * 255.0;
      draw_line(canvas, p[0], p[1], outline, Blend::replace);
      draw_line(canvas, p[1], p[2], outline, Blend::replace);
      draw_line(canvas, p[0], p[2], outline, Blend::replace);
    }
  }
}

}  // namespace
}  // namespace cgfs_07_filled_triangles

namespace textbook {
extern const Listing cgfs_07_filled_triangles;
const Listing cgfs_07_filled_triangles{
    .label = "filled triangles",
    .source = "CGFS ch. 7",
    .shows = "Triangles and lines on the canvas, filled row by row "
             "in one colour.",
    .order = ListingOrder::object_by_object,
    .reads = {},
    .draws = {.canvas_lines = true, .canvas_triangles = true},
    .suits =
        [](const SceneTraits& traits, const Settings&) {
          return traits.canvas_items ? 3 : 0;
        },
    .draw = ps::cgfs_07_filled_triangles::draw,
};
}  // namespace textbook
}  // namespace ps
