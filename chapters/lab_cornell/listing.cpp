#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <variant>
#include <vector>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace lab_cornell {
namespace {

// Rows are counted from the top, as the lab does. Whatever is to be spread over a polygon is kept with its pixels.
struct Pixel {
  int x = 0, y = 0;
  Vec3d colour{0, 0, 0};
};

constexpr int nowhere = 1 << 20;  // to the right of all pixels

// All pixels of the edge from a to b, with both ends: one for each step along its longer side.
std::vector<Pixel> interpolate_edge(const Pixel& a, const Pixel& b) {
  const int steps = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y));
  std::vector<Pixel> result;
  for (int step = 0; step <= steps; ++step) {
    const double share = steps == 0 ? 0 : static_cast<double>(step) / steps;
    // The fraction is dropped downwards. The product comes first, so that whole numbers stay whole.
    const double x = steps == 0 ? 0 : std::floor(static_cast<double>(b.x - a.x) * step / steps);
    const double y = steps == 0 ? 0 : std::floor(static_cast<double>(b.y - a.y) * step / steps);
    result.push_back({a.x + static_cast<int>(x), a.y + static_cast<int>(y), a.colour + (b.colour - a.colour) * share});
  }
  return result;
}

// For each row of the polygon its leftmost and its rightmost pixel.
void compute_polygon_rows(const std::vector<Pixel>& vertices, std::vector<Pixel>& left, std::vector<Pixel>& right) {
  int top = vertices[0].y, bottom = vertices[0].y;
  for (const Pixel& vertex : vertices) {
    top = std::min(top, vertex.y);
    bottom = std::max(bottom, vertex.y);
  }
  const int height = bottom - top + 1;
  const auto rows = static_cast<std::size_t>(height);
  PS_WATCH("rows", rows);
  left.assign(rows, {nowhere});
  right.assign(rows, {-nowhere});

  for (std::size_t i = 0; i < vertices.size(); ++i) {
    PS_EACH("edge from vertex", i);
    const auto edge = interpolate_edge(vertices[i], vertices[(i + 1) % vertices.size()]);
    PS_WATCH("pixels of the edge", edge.size());
    for (const Pixel& pixel : edge) {
      const auto row = static_cast<std::size_t>(pixel.y - top);
      if (pixel.x < left[row].x) left[row] = pixel;
      if (pixel.x > right[row].x) right[row] = pixel;
    }
  }
  for (std::size_t row = 0; row < rows; ++row) left[row].y = right[row].y = top + static_cast<int>(row);
}

void draw_polygon_rows(const BookScene& scene, BookCanvas& canvas, const std::vector<Pixel>& left,
                       const std::vector<Pixel>& right, Blend blend) {
  for (std::size_t row = 0; row < left.size(); ++row) {
    PS_REACHING("row", left[row].y);
    PS_WATCH("left, right", Vec2d(left[row].x, right[row].x));
    const int columns = right[row].x - left[row].x;
    for (int column = 0; column <= columns; ++column) {
      // The book's canvas has its origin in the centre, and y goes up.
      const int x = left[row].x + column - scene.width / 2;
      const int y = scene.height - scene.height / 2 - 1 - left[row].y;
      PS_PIXEL(x, y);
      const double share = columns == 0 ? 0 : static_cast<double>(column) / columns;
      const Vec3d colour = left[row].colour + (right[row].colour - left[row].colour) * share;
      PS_WATCH("colour", colour);
      const Vec3d mix = blended(blend, canvas.get_pixel(x, y), colour);
      PS_WATCH("canvas becomes", mix);
      canvas.put_pixel(x, y, mix);
    }
  }
}

// The pixel in which a vertex lies.
Pixel vertex_pixel(const BookScene& scene, const Vec2d& p, const Vec3d& colour) {
  return {static_cast<int>(p.x) + scene.width / 2, scene.height - scene.height / 2 - 1 - static_cast<int>(p.y),
          colour * 255.0};
}

void draw_polygon(const BookScene& scene, BookCanvas& canvas, const std::vector<Pixel>& vertices, Blend blend) {
  std::vector<Pixel> left, right;
  compute_polygon_rows(vertices, left, right);
  draw_polygon_rows(scene, canvas, left, right, blend);
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  for (const CanvasItem& item : *scene.scene.canvas_items) {
    std::vector<Pixel> vertices;
    Blend blend = Blend::replace;
    bool far = false;
    const auto add = [&](const Vec2d& p, const Vec3d& colour) {
      far = far || canvas.far_outside(p);
      vertices.push_back(far ? Pixel{} : vertex_pixel(scene, p, colour));
    };
    if (const auto* triangle = std::get_if<CanvasTriangle>(&item); triangle && triangle->filled) {
      blend = triangle->blend;
      for (std::size_t k = 0; k < 3; ++k) add(triangle->points[k], triangle->colours[k] * triangle->h[k]);
    } else if (const auto* polygon = std::get_if<CanvasPolygon>(&item); polygon && polygon->filled) {
      blend = polygon->blend;
      for (const CanvasVertex& vertex : polygon->vertices) add(vertex.point, vertex.colour * vertex.h);
    }
    if (far || vertices.empty()) continue;
    PS_REACHING("polygon with pixel", Vec2d(vertices[0].x, vertices[0].y));
    draw_polygon(scene, canvas, vertices, blend);
  }
}

}  // namespace
}  // namespace lab_cornell

namespace textbook {
extern const Listing lab_cornell;
const Listing lab_cornell{
    .label = "polygon rows",
    .source = "LAB 4",
    .shows =
        "Convex polygons on the canvas, without outlines, filled from the leftmost to the rightmost pixel of each row.",
    .order = ListingOrder::object_by_object,
    .reads = {},
    .draws = {.canvas_triangles = true, .canvas_intensities = true, .canvas_gradients = true},
    .as_settings = [](Settings& settings) { settings.canvas_fill = CanvasFill::rows; },
    .suits = [](const SceneTraits& traits, const Settings&) { return traits.canvas_triangles ? 1 : 0; },
    .draw = ps::lab_cornell::draw,
};
}  // namespace textbook
}  // namespace ps
