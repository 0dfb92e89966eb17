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

// Rows are counted from the top, as the lab does. Whatever is to be
// spread over a polygon is kept with its pixels.
struct Pixel {
  int x = 0, y = 0;
  Vec3d colour{0, 0, 0};
};

using Pixels = std::vector<Pixel>;

constexpr int nowhere = 1 << 20;  // to the right of all pixels

// All pixels of the edge from a to b, with both ends: one for each
// step along its longer side.
Pixels interpolate_edge(const Pixel& a, const Pixel& b) {
  const int columns = b.x - a.x, rows = b.y - a.y;
  const int steps = std::max(std::abs(columns), std::abs(rows));
  if (steps == 0) return {a};
  Pixels result;
  for (double step = 0; step <= steps; ++step) {
    // The fraction is dropped downwards. The product comes first,
    // so that whole numbers stay whole.
    const int x = round_down(columns * step / steps);
    const int y = round_down(rows * step / steps);
    const double share = step / steps;
    const Vec3d colour = a.colour + (b.colour - a.colour) * share;
    result.push_back({a.x + x, a.y + y, colour});
  }
  return result;
}

// For each row of the polygon its leftmost and its rightmost pixel.
void compute_polygon_rows(const Pixels& vertices, Pixels& left,
                          Pixels& right) {
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
    const Pixel& next = vertices[(i + 1) % vertices.size()];
    const Pixels edge = interpolate_edge(vertices[i], next);
    PS_WATCH("pixels of the edge", edge.size());
    for (const Pixel& pixel : edge) {
      const auto row = static_cast<std::size_t>(pixel.y - top);
      if (pixel.x < left[row].x) left[row] = pixel;
      if (pixel.x > right[row].x) right[row] = pixel;
    }
  }
  for (std::size_t row = 0; row < rows; ++row)
    left[row].y = right[row].y = top + static_cast<int>(row);
}

void draw_row(const BookScene& scene, BookCanvas& canvas,
              const Pixel& left, const Pixel& right, Blend blend) {
  PS_REACHING("row", left.y);
  PS_WATCH("left, right", Vec2d(left.x, right.x));
  const int columns = right.x - left.x;
  for (int column = 0; column <= columns; ++column) {
    // The book's canvas has its origin in the centre, and y goes
    // up.
    const int x = left.x + column - scene.width / 2;
    const int y = scene.height - scene.height / 2 - 1 - left.y;
    PS_PIXEL(x, y);
    const double whole = columns == 0 ? 1 : columns;
    const double share = column / whole;
    const Vec3d difference = right.colour - left.colour;
    const Vec3d colour = left.colour + difference * share;
    PS_WATCH("colour", colour);
    const Vec3d below = canvas.get_pixel(x, y);
    const Vec3d mix = blended(blend, below, colour);
    PS_WATCH("canvas becomes", mix);
    canvas.put_pixel(x, y, mix);
  }
}

// The pixel in which a vertex lies.
Pixel vertex_pixel(const BookScene& scene, Vec2d p, Vec3d colour) {
  const int x = static_cast<int>(p.x) + scene.width / 2;
  const int middle = scene.height - scene.height / 2 - 1;
  return {x, middle - static_cast<int>(p.y), colour * 255.0};
}

void draw_polygon(const BookScene& scene, BookCanvas& canvas,
                  const Pixels& vertices, Blend blend) {
  Pixels left, right;
  compute_polygon_rows(vertices, left, right);
  for (std::size_t row = 0; row < left.size(); ++row)
    draw_row(scene, canvas, left[row], right[row], blend);
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  for (const CanvasItem& item : *scene.scene.canvas_items) {
    Pixels vertices;
    Blend blend = Blend::replace;
    bool far = false;
    const auto add = [&](const Vec2d& p, const Vec3d& colour) {
      far = far || canvas.far_outside(p);
      if (!far) vertices.push_back(vertex_pixel(scene, p, colour));
    };
    const auto* triangle = std::get_if<CanvasTriangle>(&item);
    const auto* polygon = std::get_if<CanvasPolygon>(&item);
    if (triangle && triangle->filled) {
      blend = triangle->blend;
      const auto& h = triangle->h;
      for (std::size_t k = 0; k < 3; ++k)
        add(triangle->points[k], triangle->colours[k] * h[k]);
    }
    if (polygon && polygon->filled) {
      blend = polygon->blend;
      for (const CanvasVertex& vertex : polygon->vertices)
        add(vertex.point, vertex.colour * vertex.h);
    }
    if (far || vertices.empty()) continue;
    const Vec2d first(vertices[0].x, vertices[0].y);
    PS_REACHING("polygon with pixel", first);
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
        "Convex polygons on the canvas, without outlines, filled "
        "from the leftmost to the rightmost pixel of each row.",
    .order = ListingOrder::object_by_object,
    .reads = {},
    .draws = {.canvas_triangles = true,
              .canvas_intensities = true,
              .canvas_gradients = true},
    .as_settings =
        [](Settings& settings) {
          settings.canvas_fill = CanvasFill::rows;
        },
    .suits =
        [](const SceneTraits& traits, const Settings&) {
          return traits.canvas_triangles ? 1 : 0;
        },
    .draw = ps::lab_cornell::draw,
};
}  // namespace textbook
}  // namespace ps
