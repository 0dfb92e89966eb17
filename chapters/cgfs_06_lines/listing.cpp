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
namespace cgfs_06_lines {
namespace {

// One value of d for each whole step of i from i0 to i1: the slope
// is added again and again.
std::vector<double> interpolate(double i0, double d0, double i1,
                                double d1) {
  if (i0 == i1) return {d0};
  std::vector<double> values;
  const double a = (d1 - d0) / (i1 - i0);
  PS_WATCH("slope", a);
  double d = d0;
  for (double i = i0; i <= i1; ++i) {
    values.push_back(d);
    d += a;
  }
  return values;
}

// A line without gaps: one pixel for each step along the axis on
// which it is longer.
void draw_line(BookCanvas& canvas, Vec2d p0, Vec2d p1,
               Vec3d colour) {
  if (std::abs(p1.x - p0.x) > std::abs(p1.y - p0.y)) {
    // Rather flat: one pixel for each x.
    if (p1.x < p0.x) std::swap(p0, p1);
    const auto ys = interpolate(p0.x, p0.y, p1.x, p1.y);
    PS_WATCH("y for each x", ys.size());
    for (double x = p0.x; x <= p1.x; ++x) {
      const double y = entry(ys, x, p0.x);
      PS_PIXEL(x, y);
      PS_WATCH("y", y);
      canvas.put_pixel(x, y, colour);
      PS_WATCH("x, y as drawn",
               Vec2d(std::trunc(x), std::trunc(y)));
    }
  } else {
    // Rather steep: one pixel for each y.
    if (p1.y < p0.y) std::swap(p0, p1);
    const auto xs = interpolate(p0.y, p0.x, p1.y, p1.x);
    PS_WATCH("x for each y", xs.size());
    for (double y = p0.y; y <= p1.y; ++y) {
      const double x = entry(xs, y, p0.y);
      PS_PIXEL(x, y);
      PS_WATCH("x", x);
      canvas.put_pixel(x, y, colour);
      PS_WATCH("x, y as drawn",
               Vec2d(std::trunc(x), std::trunc(y)));
    }
  }
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const auto items = lines_and_triangles(*scene.scene.canvas_items);
  for (const CanvasItem& item : items) {
    const auto* line = std::get_if<CanvasLine>(&item);
    if (!line) continue;
    const auto& [p0, p1] = line->points;
    if (canvas.far_outside(p0) || canvas.far_outside(p1)) continue;
    PS_REACHING("line from", p0);
    PS_WATCH("to", p1);
    draw_line(canvas, p0, p1, line->colour * 255.0);
  }
}

}  // namespace
}  // namespace cgfs_06_lines

namespace textbook {
extern const Listing cgfs_06_lines;
const Listing cgfs_06_lines{
    .label = "lines",
    .source = "CGFS ch. 6",
    .shows = "Lines on the canvas.",
    .order = ListingOrder::object_by_object,
    .reads = {},
    .draws = {.canvas_lines = true},
    .suits =
        [](const SceneTraits& traits, const Settings&) {
          if (!traits.canvas_items) return 0;
          return traits.canvas_triangles ? 1 : 5;
        },
    .draw = ps::cgfs_06_lines::draw,
};
}  // namespace textbook
}  // namespace ps
