#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "raster/assembly/screen_geometry.h"
#include "raster/base/depth_test.h"
#include "study/stability/plain_scene.h"
#include "study/stability/support.h"

namespace ps::stability::inverse_depth {
namespace {

constexpr int canvas = 600, middle = canvas / 2;  ///< px, the book's

/// A wall seen edge-on: as seen from above a line from a to b, x and z. It is a triangle with two vertices at a,
/// above and below the line of sight, and one at b.
struct Wall {
  double a_x, a_z, b_x, b_z;

  double ratio() const { return b_z / a_z; }
  int first_column() const { return middle + static_cast<int>(std::lround(canvas * a_x / a_z)); }
  int last_column() const { return middle + static_cast<int>(std::lround(canvas * b_x / b_z)); }
  /// Where the ray through a column meets the wall.
  double truth(int column) const {
    const double slope = (column - middle) / double{canvas};  // x / z
    const double along = (slope * a_z - a_x) / ((b_x - a_x) - slope * (b_z - a_z));
    return a_z + along * (b_z - a_z);
  }
};

/// A wall across the picture from z = 1 at its left border to z = `ratio` at its right one.
Wall across_picture(double ratio) { return {-0.5, 1, 0.5 * ratio, ratio}; }

/// From A(-1, 0, 2) to B(1, 0, 10), the edge in the book's chapter on hidden surfaces (CGFS ch. 12).
constexpr Wall book_wall{-1, 2, 1, 10};

Scene scene_of(const Wall& wall) {
  const double half_height = 0.4 * wall.a_z;
  Mesh mesh;
  mesh.positions = {{wall.a_x, -half_height, wall.a_z}, {wall.a_x, half_height, wall.a_z}, {wall.b_x, 0, wall.b_z}};
  mesh.triangles.emplace_back().position = {0, 1, 2};
  return plain_scene("wall", std::move(mesh));
}

/// The depths that the program compares along the middle row of the picture, as z; sampled at whole pixels, as the book
/// does.
std::vector<double> depths(const Wall& wall, DepthValue value, const StabilityRun& run) {
  run.check();
  Settings settings = unlit_fragments();
  settings.sample_position = SamplePosition::corner;
  settings.depth_value = value;
  const Scene scene = scene_of(wall);
  Prepared prepared;
  Progress progress;
  const auto inputs =
      raster::make_raster_inputs<float>(scene, {scene.camera, canvas, canvas}, settings, Channel::none, prepared);
  const auto geometry = raster::make_geometry(inputs, {}, ParallelOptions{1}, progress);
  const raster::ScreenTriangle<float>& triangle = geometry.batches.at(0).triangles.at(0);
  raster::TriangleSetup<float> setup;
  setup.triangle = &triangle;
  setup.edges = *raster::make_edges(triangle.corners, inputs.grid);
  setup.inverse_area = 1.0f / static_cast<float>(setup.edges.area);
  std::vector<double> row;
  for (int column = wall.first_column(); column <= wall.last_column(); ++column) {
    const auto fragment = raster::make_fragment(inputs, setup, column, middle, setup.edges.at(column, middle));
    const double stored = static_cast<double>(raster::depth_value(inputs, setup, fragment, inputs.grid.sample));
    row.push_back(value == DepthValue::inverse_z ? 1 / stored : stored);
  }
  return row;
}

double largest_error(const Wall& wall, DepthValue value, const StabilityRun& run) {
  double largest = 0;
  int column = wall.first_column();
  for (const double z : depths(wall, value, run))
    largest = std::max(largest, std::abs(z - wall.truth(column++)) / (wall.b_z - wall.a_z));
  return largest;
}

/// How often the book's wall wins or loses wrongly against something of one depth, for all depths between its ends.
double wrongly_ordered(const std::vector<double>& row) {
  constexpr int objects = 1000;
  double wrong = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const double truth = book_wall.truth(book_wall.first_column() + static_cast<int>(i));
    for (int k = 0; k < objects; ++k) {
      const double z = book_wall.a_z + (book_wall.b_z - book_wall.a_z) * (k + 0.5) / objects;
      wrong += (row[i] < z) != (truth < z) ? 1 : 0;
    }
  }
  return percent(wrong, objects * static_cast<double>(row.size()));
}

void measure(const StabilityRun& run, Rows& rows) {
  for (const double ratio : {1.1, 2.0, 5.0, 10.0, 100.0, 1000.0}) {
    const Wall wall = across_picture(ratio);
    const char* unit = "share of the depth range";
    rows.add(ratio, "largest on the edge", largest_error(wall, DepthValue::z, run),
             largest_error(wall, DepthValue::inverse_z, run), unit);
    rows.add(ratio, "closed form: (sqrt r - 1) / (sqrt r + 1)", (std::sqrt(ratio) - 1) / (std::sqrt(ratio) + 1),
             std::nan(""), unit);
  }
  const std::vector<double> naive = depths(book_wall, DepthValue::z, run);
  const std::vector<double> robust = depths(book_wall, DepthValue::inverse_z, run);
  const auto centre = static_cast<std::size_t>(middle - book_wall.first_column());
  rows.add(book_wall.ratio(), "the book's edge", naive[centre], robust[centre], "z at the centre of the canvas");
  rows.add(book_wall.ratio(), "the book's edge before objects of one depth", wrongly_ordered(naive),
           wrongly_ordered(robust), "% of pixels that show the wrong one");
}

/// The wall from z = 2 to z = 2 `ratio`, and a board halfway between those depths.
StabilityPicture picture(double ratio) {
  const Wall wall = across_picture(ratio);
  const double z = 1 + ratio;
  StabilityPicture picture;
  picture.scene = fmt::format(
      "viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = white\n"
      "model {{\n  name = wall\n  vertices {{ ({0}, -0.8, 2) ({0}, 0.8, 2) ({1}, 0, {2}) }}\n"
      "  triangles {{ (0, 1, 2, (200, 90, 60)) }}\n}}\n"
      "model {{\n  name = board\n  vertices {{ (-{3}, -{4}, {5}) ({3}, -{4}, {5}) (-{3}, {4}, {5}) ({3}, {4}, {5}) }}\n"
      "  triangles {{ (0, 1, 2, (70, 120, 190)) (2, 1, 3, (70, 120, 190)) }}\n}}\n"
      "instance {{ model = wall }}\ninstance {{ model = board }}\n",
      2 * wall.a_x, 2 * wall.b_x, 2 * wall.b_z, 0.4 * z, 0.1 * z, z);
  picture.robust = unlit_fragments();
  picture.naive = picture.robust;
  picture.naive.depth_value = DepthValue::z;
  return picture;
}

}  // namespace

extern const StabilityExperiment inverse_depth{
    .key = "z-vs-1-z",
    .place = {Subject::depth, 20},
    .set_up = SetUp::reproduction,
    .title = "Depth interpolation: z against 1/z",
    .keywords = "z-buffer, zbuffer, depth interpolation, perspective correct, barycentric",
    .knob = "ratio of the depths of an edge's ends",
    .naive = "interpolate z on the screen (depth-value = z)",
    .robust = "interpolate 1/z (depth-value = inverse-z)",
    .explanation = "Equal steps on the screen are not equal steps in depth. 1/z is linear on the screen, z is not.",
    .safe = "Ratios up to 1.1 for an error of 2.5 % of the depth range.",
    .window = {nowhere, 1.1},
    .series = {{.names = "largest on the edge|closed form*",
                .title = "largest error of the depth",
                .unit = "share of the depth range"},
               {.names = "the book's edge",
                .title = "depth at the centre of the canvas, where 6 is right",
                .unit = "world units",
                .better = Better::neither},
               {.names = "the book's edge before*", .title = "pixels that show the wrong surface", .unit = "%"}},
    .add_rows = measure,
    .picture = picture,
    .frames = {1.1, 2.0, 5.0, 100.0}};

}  // namespace ps::stability::inverse_depth
