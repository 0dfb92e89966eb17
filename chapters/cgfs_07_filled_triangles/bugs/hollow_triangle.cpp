// The triangle has an outline and nothing inside.
#include <cmath>
#include <utility>
#include <variant>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_07_filled_triangles {
namespace {

void draw_line(BookCanvas& canvas, Vec2d p0, Vec2d p1, const Vec3d& colour, Blend blend) {
  const bool flat = std::abs(p1.x - p0.x) > std::abs(p1.y - p0.y);
  if (flat ? p1.x < p0.x : p1.y < p0.y) std::swap(p0, p1);
  const double first = flat ? p0.x : p0.y, last = flat ? p1.x : p1.y;
  const auto others = flat ? interpolate(first, p0.y, last, p1.y) : interpolate(first, p0.x, last, p1.x);
  for (double step = first; step <= last; ++step) {
    const double other = entry(others, step, first);
    const Vec2d place = flat ? Vec2d(step, other) : Vec2d(other, step);
    PS_PIXEL(place.x, place.y);
    PS_WATCH("outline at", place);
    const Vec3d mix = blended(blend, canvas.get_pixel(place.x, place.y), colour);
    PS_WATCH("canvas becomes", mix);
    canvas.put_pixel(place.x, place.y, mix);
  }
}

// Row by row, from the left side to the right one, both ends included.
void draw_filled_triangle(BookCanvas& canvas, const std::array<Vec2d, 3>& corners, const Vec3d& colour, Blend blend) {
  // Sorted by height, the first side goes from the lowest vertex to the highest; the two others share the way.
  const auto order = sorted_by_height(corners);
  const Vec2d p0 = corners[order[0]], p1 = corners[order[1]], p2 = corners[order[2]];
  PS_WATCH("lowest corner", p0);
  PS_WATCH("middle corner", p1);
  PS_WATCH("highest corner", p2);
  const auto x = interpolate_sides<double>({p0.y, p1.y, p2.y}, {p0.x, p1.x, p2.x});
  PS_WATCH("rows", x.long_side.size());

  // Which is left shows in the middle.
  const std::size_t middle = x.long_side.size() / 2;
  const bool long_is_left = x.long_side[middle] > x.short_sides[middle];
  PS_WATCH("long side is left", long_is_left);
  const auto& x_left = long_is_left ? x.long_side : x.short_sides;
  const auto& x_right = long_is_left ? x.short_sides : x.long_side;

  for (double y = p0.y; y <= p2.y; ++y) {
    PS_REACHING("row", y);
    const double left = entry(x_left, y, p0.y), right = entry(x_right, y, p0.y);
    PS_WATCH("left, right", Vec2d(left, right));
    for (double column = left; column <= right; ++column) {
      PS_PIXEL(column, y);
      PS_WATCH("x", column);
      PS_WATCH("colour", colour);
      const Vec3d mix = blended(blend, canvas.get_pixel(column, y), colour);
      PS_WATCH("canvas becomes", mix);
      canvas.put_pixel(column, y, mix);
    }
  }
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  for (const CanvasItem& item : lines_and_triangles(*scene.scene.canvas_items)) {
    if (const auto* line = std::get_if<CanvasLine>(&item)) {
      if (canvas.far_outside(line->points[0]) || canvas.far_outside(line->points[1])) continue;
      PS_REACHING("line from", line->points[0]);
      draw_line(canvas, line->points[0], line->points[1], line->colour * 255.0, line->blend);
      continue;
    }
    const auto& triangle = std::get<CanvasTriangle>(item);
    std::array<Vec2d, 3> p = triangle.points;
    if (canvas.far_outside(p[0]) || canvas.far_outside(p[1]) || canvas.far_outside(p[2])) continue;
    for (Vec2d& corner : p) corner = {std::trunc(corner.x), std::trunc(corner.y)};  // rows are whole numbers
    PS_REACHING("triangle with vertex", p[0]);
    if (triangle.filled) draw_filled_triangle(canvas, p, triangle.colours[0] * 255.0, triangle.blend);
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
    .shows = "Triangles and lines on the canvas, filled row by row in one colour.",
    .order = ListingOrder::object_by_object,
    .reads = {},
    .draws = {.canvas_lines = true, .canvas_triangles = true},
    .suits = [](const SceneTraits& traits, const Settings&) { return traits.canvas_items ? 3 : 0; },
    .draw = ps::cgfs_07_filled_triangles::draw,
};
}  // namespace textbook
}  // namespace ps
