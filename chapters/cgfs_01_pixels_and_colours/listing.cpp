#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace cgfs_01_pixels_and_colours {
namespace {

// The last step of every picture: from the light of a channel, with
// 1 for white, to the whole number that is stored.
double level_of(double light, double exposure, double gamma) {
  const double exposed = light * exposure;
  PS_WATCH("exposed", exposed);
  const double clamped = std::min(1.0, std::max(0.0, exposed));
  PS_WATCH("clamped", clamped);
  const double bent = power(clamped, 1 / gamma);
  PS_WATCH("bent", bent);
  return std::nearbyint(bent * 255);
}

// The way back: the light for which a level stands.
double light_of(double level, double exposure, double gamma) {
  return power(level / 255, gamma) / exposure;
}

// Twice the area of the triangle a, b, p: its sign says on which
// side of the line from a to b the point p lies.
double side(Vec2d a, Vec2d b, Vec2d p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

// Inside, a point is on the same side of all three edges.
bool is_inside(const std::array<Vec2d, 3>& v, Vec2d p) {
  const double first = side(v[0], v[1], p);
  const double second = side(v[1], v[2], p);
  const double third = side(v[2], v[0], p);
  const bool left = first >= 0 && second >= 0 && third >= 0;
  const bool right = first <= 0 && second <= 0 && third <= 0;
  return left || right;
}

// Light of a triangle comes to that of the pixels which it covers.
void add_light(BookCanvas& canvas, const CanvasTriangle& triangle) {
  const Vec3d colour = triangle.colours[0] * 255.0;
  for (int y = canvas.bottom(); y < canvas.top(); ++y) {
    for (int x = canvas.left(); x < canvas.right(); ++x) {
      if (!is_inside(triangle.points, Vec2d(x, y))) continue;
      PS_PIXEL(x, y);
      const Vec3d below = canvas.get_pixel(x, y);
      PS_WATCH("light so far", below);
      const Vec3d sum = blended(triangle.blend, below, colour);
      PS_WATCH("canvas becomes", sum);
      canvas.put_pixel(x, y, sum);
    }
  }
}

// Each pixel is stored as three levels. The canvas takes light, so
// it gets the light for which they stand.
void store(BookCanvas& canvas, double exposure, double gamma) {
  for (int y = canvas.bottom(); y < canvas.top(); ++y) {
    for (int x = canvas.left(); x < canvas.right(); ++x) {
      PS_PIXEL(x, y);
      const Vec3d sum = canvas.get_pixel(x, y);
      PS_WATCH("on the canvas", sum);
      Vec3d levels(0, 0, 0), shown(0, 0, 0);
      for (int i = 0; i < 3; ++i) {
        PS_EACH("channel, from red", i);
        const double light = sum[i] / 255;
        PS_WATCH("light", light);
        levels[i] = level_of(light, exposure, gamma);
        PS_WATCH("level", levels[i]);
        shown[i] = 255 * light_of(levels[i], exposure, gamma);
      }
      PS_WATCH("stored levels", levels);
      canvas.put_pixel(x, y, shown);
      PS_WATCH("light of these levels", shown);
    }
  }
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const auto items = lines_and_triangles(*scene.scene.canvas_items);
  for (const CanvasItem& item : items) {
    const auto* triangle = std::get_if<CanvasTriangle>(&item);
    if (!triangle || !triangle->filled) continue;
    PS_REACHING("triangle with vertex", triangle->points[0]);
    add_light(canvas, *triangle);
  }
  store(canvas, scene.settings.exposure, scene.settings.gamma);
}

}  // namespace
}  // namespace cgfs_01_pixels_and_colours

namespace textbook {
extern const Listing cgfs_01_pixels_and_colours;
const Listing cgfs_01_pixels_and_colours{
    .label = "light and levels",
    .source = "CGFS ch. 1",
    .shows = "Triangles on the canvas, whose light is added and "
             "then stored as levels of 8 bits.",
    .order = ListingOrder::object_by_object,
    .reads = {"exposure", "gamma"},
    .draws = {.canvas_triangles = true},
    // Scenes that no listing shows stay with the listings on space.
    .suits =
        [](const SceneTraits& traits, const Settings&) {
          return traits.canvas_triangles ? 1 : -1;
        },
    .draw = ps::cgfs_01_pixels_and_colours::draw,
};
}  // namespace textbook
}  // namespace ps
