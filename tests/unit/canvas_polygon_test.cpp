// Convex polygons of any number of corners on the canvas (LAB 4), against half planes and the lab's own rows.
#include <gtest/gtest.h>

#include <cmath>

#include "base/check.h"
#include "options/scene_settings.h"
#include "raster/clear/polygon_rows.h"
#include "scene/scene_file.h"
#include "scene/scene_writer.h"
#include "support/refusal.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::canvas_polygon_test {
namespace {

constexpr int polygon_side = 40;

Scene scene_of(const std::string& text) { return parse_scene("background = black\n" + text, "polygon.scene", "."); }

Frame drawn(const Scene& scene) {
  Settings settings = settings_for(scene, Renderer::rasterizer);
  return render(scene, {scene.camera, polygon_side, polygon_side}, settings, request_for(Channel::overdraw));
}

Frame drawn(const std::string& text) { return drawn(scene_of(text)); }

std::string list_of(const std::vector<Vec2d>& points) {
  std::string list;
  for (const Vec2d& p : points)
    list += (list.empty() ? "(" : ", (") + std::to_string(p.x) + ", " + std::to_string(p.y) + ")";
  return "[" + list + "]";
}

/// Corners on an ellipse, so convex; the angles keep the edges off all pixel centres.
std::vector<Vec2d> on_ellipse(int corners, double direction) {
  std::vector<Vec2d> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = direction * 6.2831853 * (i + 0.137) / corners;
    points.emplace_back(17.31 * std::cos(angle), 11.87 * std::sin(angle));
  }
  return points;
}

TEST(CanvasPolygon, CoversEachPixelOfItsInsideOnce) {
  for (const int corners : {3, 4, 5, 8, 31})
    for (const double direction : {1.0, -1.0}) {
      const auto points = on_ellipse(corners, direction);
      const Frame frame = drawn("polygon { vertices = " + list_of(points) + " color = red blend = additive }");
      int inside = 0;
      for (int y = 0; y < polygon_side; ++y)
        for (int x = 0; x < polygon_side; ++x) {
          const Vec2d p{x + 0.5 - polygon_side / 2.0, polygon_side / 2.0 - y - 0.5};
          double least = 1e9;
          for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec2d a = points[i], b = points[(i + 1) % points.size()], e = b - a;
            least = std::min(least, direction * (e.x * (p.y - a.y) - e.y * (p.x - a.x)) / std::hypot(e.x, e.y));
          }
          if (std::abs(least) < 0.01) continue;  // corners are snapped to 1/256 pixel
          inside += least > 0;
          EXPECT_EQ(frame.overdraw.at(x, y), least > 0 ? 1u : 0u) << corners << " at " << x << ", " << y;
          EXPECT_NEAR(frame.colour.at(x, y).x, least > 0 ? 1 : 0, 1e-6);
        }
      EXPECT_GT(inside, corners == 3 ? 200 : 350);
    }
}

// The two edges that lead to a vertex far away are parallel in the picture.
TEST(CanvasPolygon, CoversWhatLiesTowardsAVertexFarAway) {
  for (const std::string precision : {"float", "double"})
    for (const double away : {1e6, 1e37, 1e300}) {
      Scene scene = scene_of("settings { precision = " + precision +
                             " }\ntriangle { vertices = [(-10.3, -12.2), (12.4, -12.2), (-9, 9)] color = red }");
      scene.canvas_items.edit([away](std::vector<CanvasItem>& items) {
        std::get<CanvasTriangle>(items[0]).points[2] = {-away, away};
      });
      const Frame frame = drawn(scene);
      int inside = 0;
      for (int y = 0; y < polygon_side; ++y)
        for (int x = 0; x < polygon_side; ++x) {
          const Vec2d p{x + 0.5 - polygon_side / 2.0, polygon_side / 2.0 - y - 0.5};
          const double least =
              std::min({p.y + 12.2, (p.x + p.y + 22.5) / std::sqrt(2.0), (0.2 - p.x - p.y) / std::sqrt(2.0)});
          if (std::abs(least) < 0.02) continue;
          inside += least > 0;
          EXPECT_EQ(frame.overdraw.at(x, y), least > 0 ? 1u : 0u)
              << precision << ", " << away << " at " << x << ", " << y;
        }
      EXPECT_GT(inside, 350);
    }
}

// The lab's rows hold every pixel that the polygon covers: they take edges as inside.
TEST(CanvasPolygon, LiesWithinTheRowsOfTheLab) {
  const std::vector<Vec2i> corners{{-15, -3}, {-6, -14}, {12, -10}, {16, 4}, {2, 15}};
  std::vector<Vec2d> points(corners.begin(), corners.end());
  const Frame frame =
      drawn("settings { sample-position = corner }\npolygon { vertices = " + list_of(points) + " color = red }");
  int covered = 0, in_rows = 0;
  std::map<int, raster::PolygonRow> rows;
  for (const raster::PolygonRow& row : raster::polygon_rows(corners)) {
    rows[row.y] = row;
    in_rows += row.right.x - row.left.x + 1;
  }
  for (int y = 0; y < polygon_side; ++y)
    for (int x = 0; x < polygon_side; ++x) {
      if (frame.overdraw.at(x, y) == 0) continue;
      ++covered;
      const int column = x - polygon_side / 2, height = polygon_side / 2 - 1 - y;  // the book's names of the pixel
      const auto row = rows.find(height);
      ASSERT_NE(row, rows.end()) << height;
      EXPECT_GE(column, row->second.left.x) << height;
      EXPECT_LE(column, row->second.right.x) << height;
    }
  EXPECT_GT(covered, 500);
  EXPECT_LE(covered, in_rows);
  EXPECT_LT(in_rows - covered, 80) << "the border alone";
}

TEST(CanvasPolygon, ColoursOfItsCornersAndItsOutline) {
  const Frame frame = drawn("polygon { vertices = [(-15, -15), (15, -15), (15, 15), (-15, 15)]\n"
                            "  colors = [red, red, blue, blue] h = [1, 1, 0.5, 0.5] outline = white }");
  const Vec3f middle = frame.colour.at(polygon_side / 2, polygon_side / 2);  // at y = -0.5, so 14.5 / 30 of the way up
  EXPECT_NEAR(middle.x, 1 - 14.5 / 30, 1e-5);
  EXPECT_NEAR(middle.z, 0.5 * 14.5 / 30, 1e-5);
  EXPECT_EQ(frame.colour.at(polygon_side / 2, polygon_side / 2 + 14), Vec3f(1));
}

// It stays a polygon when it is written; what knows lines and triangles alone gets its triangles and its outline.
TEST(CanvasPolygon, IsOneItemThatIsWrittenAndReadBack) {
  const std::string text = "polygon { vertices = [(0, 0), (5, 0), (10, 0), (10, 10)] colors = [red, blue, red, white]\n"
                           "  h = [1, 0.5, 1, 2] outline = white blend = additive }\n"
                           "polygon { vertices = [(0, 0), (0, 9), (9, 9), (9, 0)] filled = off outline = red }\n";
  const Scene scene = parse_scene(text, "p.scene", ".");
  ASSERT_EQ(scene.canvas_items->size(), 2u);
  EXPECT_TRUE(scene_traits(scene).canvas_triangles);
  const auto& polygon = std::get<CanvasPolygon>((*scene.canvas_items)[0]);
  EXPECT_EQ(polygon.vertices.size(), 4u);
  const Scene again = parse_scene(write_scene(scene, "."), "again.scene", ".");
  EXPECT_EQ(*again.canvas_items, *scene.canvas_items);
  const auto plain = lines_and_triangles(*scene.canvas_items);
  std::size_t lines = 0, triangles = 0;
  for (const CanvasItem& item : plain) {
    lines += std::holds_alternative<CanvasLine>(item) ? 1u : 0u;
    triangles += std::holds_alternative<CanvasTriangle>(item) ? 1u : 0u;
  }
  EXPECT_EQ(lines, 8u);
  EXPECT_EQ(triangles, 1u) << "that on a line has no area, and the other polygon is not filled";
}

TEST(CanvasPolygon, RefusesWhatIsNotConvex) {
  const auto refused = [](const std::string& vertices) {
    return test::refusal_of([&] { parse_scene("\npolygon { vertices = " + vertices + " }", "p.scene", "."); })
        .starts_with("p.scene:2:22: ");
  };
  EXPECT_TRUE(refused("[(0, 0), (10, 0), (5, 2), (0, 10)]")) << "a dent";
  EXPECT_TRUE(refused("[(0, 10), (6, -8), (-10, 3), (10, 3), (-6, -8)]")) << "a star, which goes round twice";
  EXPECT_TRUE(refused("[(0, 0), (1, 1), (2, 2)]")) << "a line";
  EXPECT_TRUE(refused("[(0, 0), (1, 1)]"));
  EXPECT_FALSE(refused("[(0, 0), (5, 0), (10, 0), (10, 10)]")) << "a corner on an edge is no dent";
}

}  // namespace
}  // namespace ps::canvas_polygon_test
