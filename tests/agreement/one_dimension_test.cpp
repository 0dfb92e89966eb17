// CGPP exercise 15.5: segments of a number line against pixel centres at whole numbers, by formula.
#include <gtest/gtest.h>

#include <set>

#include "options/scene_settings.h"
#include "raster/clear/coverage/walk.h"
#include "scene/load.h"
#include "support/render_once.h"

namespace ps::one_dimension_test {
namespace {

/// Whole numbers in [a, b) after both ends were rounded to 1 / 2^bits, halves to even.
std::set<int> centres(double a, double b, int bits) {
  const double unit = std::ldexp(1.0, bits);
  const double first = std::nearbyint(a * unit) / unit, last = std::nearbyint(b * unit) / unit;
  std::set<int> columns;
  for (int column = 0; column < 24; ++column)
    if (column >= first && column < last) columns.insert(column);
  return columns;
}

/// A segment of the scene in pixels, and its row.
struct Segment {
  double from = 0, to = 0;
  int row = 0;
};

std::vector<Segment> segments_of(const Scene& scene) {
  std::vector<Segment> segments;
  for (const Object& object : scene.geometry->objects) {
    const auto& rectangle = std::get<Rectangle>(std::get<Solid>(object.shape).form);
    const double from = rectangle.corner.x + 12;
    segments.push_back({from, from + rectangle.side_a.x, static_cast<int>(std::floor(4 - rectangle.corner.y))});
  }
  return segments;
}

// The scene's own segments, by their ends.
TEST(OneDimension, SceneCoversWhatTheFormulaSays) {
  const Scene scene = load_scene("cgpp/one-dimension");
  const std::vector<Segment> segments = segments_of(scene);
  ASSERT_EQ(segments.size(), 16u);
  Settings settings = settings_for(scene);
  for (const int bits : {0, 1, 2, 8, 12}) {
    settings.subpixel_bits = bits;
    const Frame frame = render(scene, {scene.camera, 24, 10}, settings, request_for(Channel::ids));
    for (int row = 0; row < 10; ++row) {
      std::set<int> expected, drawn;
      for (const Segment& segment : segments)
        if (segment.row == row) expected.merge(centres(segment.from, segment.to, bits));
      for (int column = 0; column < 24; ++column)
        if (frame.ids.at(column, row).object >= 0) drawn.insert(column);
      EXPECT_EQ(drawn, expected) << "row " << row << ", " << bits << " bits";
    }
  }
}

bool covers_any(double a, double b, int bits) {
  const raster::CoverageGrid grid{bits, FillRule::top_left, {0, 0}};
  const auto corner = [&](double x, double y) { return raster::to_fixed(Vec2d(x, y), bits); };
  for (const auto& corners :
       {std::array{corner(a, 0), corner(b, 0), corner(a, 1)}, std::array{corner(b, 0), corner(b, 1), corner(a, 1)}}) {
    const auto edges = raster::make_edges(corners, grid);
    for (int column = 0; edges && column < 24; ++column)
      if (edges->inside(edges->at(column, 0))) return true;
  }
  return false;
}

/// The longest segment between the centres 3 and 4, ends in steps of 1/steps, that covers none.
double longest_hidden(int bits, int steps) {
  int longest = 0;
  for (int a = 1; a < steps; ++a)
    for (int b = steps - 1; b - a > longest; --b)
      if (!covers_any(3 + static_cast<double>(a) / steps, 3 + static_cast<double>(b) / steps, bits)) longest = b - a;
  return static_cast<double>(longest) / steps;
}

TEST(OneDimension, AnswersOfTheExercise) {
  EXPECT_NEAR(longest_hidden(12, 4096), 1, 2.5 / 4096);             // one pixel, without its ends
  EXPECT_NEAR(longest_hidden(0, 256), 0.5, 2.5 / 256);              // both ends round to the same centre
  EXPECT_NEAR(longest_hidden(8, 4096), 1 - 0.5 / 256, 2.5 / 4096);  // the left end must not round to the centre
}

}  // namespace
}  // namespace ps::one_dimension_test
