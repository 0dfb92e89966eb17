#include <cmath>

#include <fmt/format.h>

#include "render/renderer_table.h"
#include "scene/scene_file.h"
#include "study/stability/support.h"

namespace ps::stability::driver_snapping {
namespace {

constexpr int columns = 16, rows = 4096;
constexpr int first_row = 64, end_row = rows - 64;  // of those that are counted; the edge goes beyond them
constexpr double left = 1.25;                       // column, kept by any number of bits above 1
constexpr double start = 7.0;                       // column of the edge in the first row that is counted

/// Where the edge is at this height: it crosses one column while it passes the rows that are counted.
double edge_at(double y, double moved) { return start + moved + (y - first_row) / (end_row - first_row); }

/// A strip from the column `left` to an edge that is nearly upright, one unit before the eye.
std::string strip_text(double moved) {
  constexpr double top = 16, bottom = rows - 16;  // within the picture: nothing is clipped
  const auto place = [](double x, double y) {
    return fmt::format("({}, {}, 1)", (x - columns / 2.0) / rows, (rows / 2.0 - y) / rows);
  };
  return fmt::format(R"(canvas_size = {} x {}
viewport_size = {} x 1
projection_plane_d = 1
background = black
model {{
    name = strip
    vertices {{
        0 = {}
        1 = {}
        2 = {}
        3 = {}
    }}
    triangles {{
        0 = {{ vertices = [0, 1, 2] }}
        1 = {{ vertices = [0, 2, 3] }}
    }}
}}
instance {{
    model = strip
}}
)",
                     columns, rows, static_cast<double>(columns) / rows, place(left, bottom),
                     place(edge_at(bottom, moved), bottom), place(edge_at(top, moved), top), place(left, top));
}

/// How far the mean column of the edge, over the rows that are counted, lies from where it is: pixels. In a row that
/// the edge meets at column x, those pixels are covered whose middles lie before it: ceil(x - 1/2) up to its own. Over
/// one whole column the mean of that is the mean of x.
double off_by(const Settings& settings, double moved, const StabilityRun& run) {
  const Scene scene = parse_scene(strip_text(moved), "strip", {});
  const Frame frame = picture_of(scene, {scene.camera, columns, rows}, settings, Channel::ids, run);
  double covered = 0;
  for (int y = first_row; y < end_row; ++y)
    for (int x = 0; x < columns; ++x) covered += frame.ids.at(x, y).object >= 0 ? 1 : 0;
  const double measured = std::ceil(left - 0.5) + covered / (end_row - first_row);
  return std::abs(measured - edge_at((first_row + end_row) / 2.0, moved));
}

Settings strip_settings(Renderer renderer, int bits) {
  Settings settings;
  settings.renderer = renderer;
  settings.lighting = false;
  settings.backface_culling = false;
  settings.subpixel_bits = bits;
  settings.near = 0.5;
  return settings;
}

void measure_edge(const StabilityRun& run, Rows& measured) {
  const Renderer triangles = renderer_for(PictureWay::fragments);
  for (int step = 0; step <= 16; ++step) {
    const double moved = step / 2048.0;
    const double driver = off_by(strip_settings(driver_renderer().value(), 8), moved, run);
    measured.add(moved, "edge", driver, off_by(strip_settings(triangles, 12), moved, run), "pixels");
    measured.add(moved, "edge, both to 8 bits", driver, off_by(strip_settings(triangles, 8), moved, run), "pixels");
  }
}

}  // namespace

extern const StabilityExperiment driver_snapping{
    .key = "driver-snapping",
    .place = {Subject::coverage, 55},
    .title = "Sub-pixel bits of a graphics driver",
    .keywords = "snapping, fixed point, vertex precision, wobble, hardware, OpenGL, SUBPIXEL_BITS",
    .knob = "how far the edge has moved (pixels)",
    .naive = "vertices as the driver rounds them",
    .robust = "the rasterizer with 12 sub-pixel bits",
    .explanation = "A graphics driver rounds vertices to fractions of a pixel, and no option gives it more bits. An "
                   "edge that moves slowly stays in place, then jumps by one such fraction. The rasterizer rounds "
                   "vertices as well, to as many bits as the option subpixel-bits says.",
    .safe = "Movements of many sub-pixels in each picture.",
    .window = nowhere_safe,
    .series = {{.names = "edge", .title = "distance of the edge from its place", .unit = "pixels"},
               {.names = "edge, both to 8 bits",
                .title = "distance of the edge from its place",
                .unit = "pixels",
                .robust = "the rasterizer with 8 sub-pixel bits"}},
    .add_rows = measure_edge,
    .measures_driver = true};

}  // namespace ps::stability::driver_snapping
