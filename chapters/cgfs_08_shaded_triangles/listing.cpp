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
namespace cgfs_08_shaded_triangles {
namespace {

// One pixel of a shape: paint covers what is below, light is added
// to it.
void mix_pixel(BookCanvas& canvas, double x, double y, Vec3d colour,
               Blend blend) {
  const Vec3d below = canvas.get_pixel(x, y);
  canvas.put_pixel(x, y, blended(blend, below, colour));
}

// A vertex and its attribute are one thing: sorting moves both.
struct Vertex {
  double x = 0, y = 0;
  double h = 1;
};

// x and h on each row, along the long edge of the triangle and
// along the two short ones.
struct Edges {
  std::vector<double> x02, x012, h02, h012;
};

// interpolate() is that of chapter 6.
Edges interpolate_along_edges(Vertex p0, Vertex p1, Vertex p2) {
  const auto x02 = interpolate(p0.y, p0.x, p2.y, p2.x);
  const auto h02 = interpolate(p0.y, p0.h, p2.y, p2.h);
  auto x01 = interpolate(p0.y, p0.x, p1.y, p1.x);
  auto h01 = interpolate(p0.y, p0.h, p1.y, p1.h);
  const auto x12 = interpolate(p1.y, p1.x, p2.y, p2.x);
  const auto h12 = interpolate(p1.y, p1.h, p2.y, p2.h);

  // Concatenate the short edges: the row of p1 is in both of them.
  x01.pop_back();
  x01.insert(x01.end(), x12.begin(), x12.end());
  h01.pop_back();
  h01.insert(h01.end(), h12.begin(), h12.end());
  return {x02, x01, h02, h01};
}

void draw_shaded_triangle(BookCanvas& canvas, Vertex p0, Vertex p1,
                          Vertex p2, Vec3d colour, Blend blend) {
  // Sort by height, from below.
  if (p1.y < p0.y) std::swap(p1, p0);
  if (p2.y < p0.y) std::swap(p2, p0);
  if (p2.y < p1.y) std::swap(p2, p1);
  PS_WATCH("h0", p0.h);
  PS_WATCH("h1", p1.h);
  PS_WATCH("h2", p2.h);

  // x decides which edge is the left one, and h follows.
  Edges edges = interpolate_along_edges(p0, p1, p2);
  const std::size_t m = edges.x012.size() / 2;
  if (edges.x012[m] <= edges.x02[m]) {
    std::swap(edges.x02, edges.x012);
    std::swap(edges.h02, edges.h012);
  }
  const auto &x_left = edges.x02, &x_right = edges.x012;
  const auto &h_left = edges.h02, &h_right = edges.h012;

  for (double y = p0.y; y <= p2.y; ++y) {
    PS_REACHING("row", y);
    const double x_l = std::trunc(entry(x_left, y, p0.y));
    const double x_r = std::trunc(entry(x_right, y, p0.y));
    const double h_l = entry(h_left, y, p0.y);
    const double h_r = entry(h_right, y, p0.y);
    PS_WATCH("left, right", Vec2d(x_l, x_r));
    PS_WATCH("h at the left", h_l);
    PS_WATCH("h at the right", h_r);
    const auto h_segment = interpolate(x_l, h_l, x_r, h_r);
    for (double x = x_l; x <= x_r; ++x) {
      PS_PIXEL(x, y);
      const double h = entry(h_segment, x, x_l);
      PS_WATCH("h", h);
      const Vec3d shaded_colour = colour * h;
      PS_WATCH("colour", shaded_colour);
      mix_pixel(canvas, x, y, shaded_colour, blend);
      PS_WATCH("canvas becomes", canvas.get_pixel(x, y));
    }
  }
}

// As in the chapter before.
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
    const Vertex v0{p[0].x, p[0].y, triangle.h[0]};
    const Vertex v1{p[1].x, p[1].y, triangle.h[1]};
    const Vertex v2{p[2].x, p[2].y, triangle.h[2]};
    if (triangle.filled)
      draw_shaded_triangle(canvas, v0, v1, v2, colour, blend);
    if (triangle.outline) {
      const Vec3d outline = *triangle.outline * 255.0;
      draw_line(canvas, p[0], p[1], outline, Blend::replace);
      draw_line(canvas, p[1], p[2], outline, Blend::replace);
      draw_line(canvas, p[0], p[2], outline, Blend::replace);
    }
  }
}

}  // namespace
}  // namespace cgfs_08_shaded_triangles

namespace textbook {
extern const Listing cgfs_08_shaded_triangles;
const Listing cgfs_08_shaded_triangles{
    .label = "shaded triangles",
    .source = "CGFS ch. 8",
    .shows = "Triangles on the canvas with an intensity at each "
             "vertex, interpolated along the edges and the rows.",
    .order = ListingOrder::object_by_object,
    .reads = {},
    .draws = {.canvas_lines = true,
              .canvas_triangles = true,
              .canvas_intensities = true},
    .suits =
        [](const SceneTraits& traits, const Settings&) {
          if (!traits.canvas_items) return 0;
          return traits.canvas_intensities ? 4 : 1;
        },
    .draw = ps::cgfs_08_shaded_triangles::draw,
};
}  // namespace textbook
}  // namespace ps
