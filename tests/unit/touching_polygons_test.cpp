// Polygons that touch themselves at vertices: outlines of random sets of squares, walked in one path. Their area is the
// number of squares, and no triangle may reach out of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "scene/polygon.h"

namespace ps::touching_polygons_test {
namespace {

using Place = std::pair<int, int>;

CutPolygon cut(const std::vector<Vec3d>& corners) {
  std::int64_t work = most_polygon_work;
  return triangulate_polygon(corners, work);
}

Vec3d area_of(const std::vector<Vec3d>& corners, const std::array<std::uint32_t, 3>& t) {
  return cross(corners[t[1]] - corners[t[0]], corners[t[2]] - corners[t[0]]) / 2.0;
}

/// Sum of the areas, and of the areas that face as `facing` does.
std::pair<double, double> areas(const std::vector<Vec3d>& corners, const Vec3d& facing) {
  std::pair<double, double> sum{0, 0};
  for (const auto& triangle : cut(corners).triangles) {
    const Vec3d area = area_of(corners, triangle);
    sum.first += std::sqrt(dot(area, area));
    sum.second += dot(area, facing);
  }
  return sum;
}

struct Outline {
  std::vector<Place> path;
  int squares = 0;
};

/// The outline of random squares of a grid as one path with the squares on its left (Hierholzer's way to walk every
/// edge once), in a random order at the vertices where it touches itself. No path if it falls apart.
Outline random_outline(std::mt19937& random) {
  const int size = 2 + static_cast<int>(random() % 6);
  const auto fill = 30 + random() % 40;
  std::map<Place, bool> filled;
  std::map<Place, std::vector<Place>> edges;
  Outline outline;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      if (random() % 100 < fill) filled[{x, y}] = true;
  std::size_t count = 0;
  for (const auto& [square, ignored] : filled) {
    const int x = square.first, y = square.second;
    const auto side = [&](int dx, int dy, Place from, Place to) {
      if (filled.count({x + dx, y + dy}) > 0) return;
      edges[from].push_back(to);
      ++count;
    };
    side(0, -1, {x, y}, {x + 1, y});
    side(1, 0, {x + 1, y}, {x + 1, y + 1});
    side(0, 1, {x + 1, y + 1}, {x, y + 1});
    side(-1, 0, {x, y + 1}, {x, y});
    ++outline.squares;
  }
  if (edges.empty()) return {};
  for (auto& [from, to] : edges) std::shuffle(to.begin(), to.end(), random);
  std::vector<Place> stack{edges.begin()->first};
  while (!stack.empty()) {
    std::vector<Place>& onwards = edges[stack.back()];
    if (onwards.empty()) {
      outline.path.push_back(stack.back());
      stack.pop_back();
    } else {
      const Place next = onwards.back();
      onwards.pop_back();
      stack.push_back(next);
    }
  }
  if (outline.path.size() != count + 1) return {};
  outline.path.pop_back();
  std::reverse(outline.path.begin(), outline.path.end());
  return outline;
}

TEST(TouchingPolygons, OutlinesOfSquaresKeepTheirArea) {
  const unsigned seed = 20261128;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  int tried = 0;
  while (tried < 1500) {
    Outline outline = random_outline(random);
    if (outline.path.empty()) continue;
    ++tried;
    std::rotate(outline.path.begin(), outline.path.begin() + static_cast<int>(random() % outline.path.size()),
                outline.path.end());
    const bool is_reversed = random() % 2 == 1;
    if (is_reversed) std::reverse(outline.path.begin(), outline.path.end());
    // Turned by any angle and tilted: rows of vertices are rows but for rounding.
    const double angle = tried % 3 == 0 ? 0 : static_cast<double>(random() % 1000);
    const Vec3d u{std::cos(angle), std::sin(angle), 0.25}, v{-std::sin(angle), std::cos(angle), -0.5};
    std::vector<Vec3d> corners;
    for (const auto& [x, y] : outline.path) corners.push_back(double(x) * u + double(y) * v + Vec3d{7, -3, 2});
    const Vec3d square = cross(u, v);
    const double size = std::sqrt(dot(square, square));
    const auto [area, facing] = areas(corners, square / (is_reversed ? -size : size));
    ASSERT_FALSE(cut(corners).crosses_itself) << tried;
    ASSERT_NEAR(area, outline.squares * size, 1e-9) << tried;
    ASSERT_NEAR(facing, outline.squares * size, 1e-9) << tried;
    ASSERT_EQ(cut(corners).triangles.size(), corners.size() - 2);
  }
}

/// Two squares that meet at the origin, the second running the other way round.
TEST(TouchingPolygons, LoopsOfBothDirectionsAreFilled) {
  const std::vector<Vec3d> loops{{0, 0, 0}, {1, 0, 0},  {1, 1, 0},   {0, 1, 0},
                                 {0, 0, 0}, {0, -1, 0}, {-1, -1, 0}, {-1, 0, 0}};
  std::vector<Vec3d> opposed = loops;
  std::reverse(opposed.begin() + 5, opposed.end());
  for (std::size_t first = 0; first < loops.size(); ++first) {
    for (std::vector<Vec3d> corners : {loops, opposed}) {
      std::rotate(corners.begin(), corners.begin() + static_cast<int>(first), corners.end());
      const auto [area, facing] = areas(corners, {0, 0, 1});
      EXPECT_DOUBLE_EQ(area, 2) << first;
      EXPECT_DOUBLE_EQ(std::abs(facing), 2) << first << ": one facing";
    }
  }
}

TEST(TouchingPolygons, HolesReachedByBridges) {
  // A square of 6 with two square holes of 1, each reached from a vertex and left the same way.
  const std::vector<Vec3d> outer{{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}};
  std::vector<Vec3d> corners{outer[0]};
  for (const Vec3d& v : {Vec3d{1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}}) corners.push_back(v);
  corners.insert(corners.end(), outer.begin(), outer.begin() + 3);
  for (const Vec3d& v : {Vec3d{5, 5, 0}, {5, 4, 0}, {4, 4, 0}, {4, 5, 0}, {5, 5, 0}}) corners.push_back(v);
  corners.insert(corners.end(), outer.begin() + 2, outer.end());
  for (std::size_t first = 0; first < corners.size(); ++first) {
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    const auto [area, facing] = areas(corners, {0, 0, 1});
    EXPECT_NEAR(area, 34, 1e-12) << first;
    EXPECT_NEAR(facing, 34, 1e-12) << first;
  }
}

/// Vertices of a regular polygon with `count` of them, of which each `step`th one is the next: a star that crosses
/// itself between vertices if the step is 2 or more, but not the way round in one step.
TEST(TouchingPolygons, OutlinesThatCrossBetweenVerticesAreNoticed) {
  for (const int count : {5, 7, 9, 31})
    for (int step = 1; step < count; ++step) {
      std::vector<Vec3d> star;
      for (int i = 0; i < count; ++i) {
        const double angle = 2 * 3.14159265358979 * i * step / count;
        star.emplace_back(std::cos(angle), std::sin(angle), std::cos(angle) / 3);
      }
      if (std::gcd(count, step) > 1) continue;  // runs along its edges several times
      EXPECT_EQ(cut(star).crosses_itself, step > 1 && step < count - 1) << count << " " << step;
      EXPECT_EQ(cut(star).triangles.size(), star.size() - 2);
    }
  std::vector<Vec3d> bow_tie{{0, 0, 5}, {3, 2, 5}, {3, 0, 5}, {0, 2, 5}};
  EXPECT_TRUE(cut(bow_tie).crosses_itself);
  std::swap(bow_tie[1], bow_tie[2]);  // a rectangle
  EXPECT_FALSE(cut(bow_tie).crosses_itself);
}

TEST(TouchingPolygons, ManyVerticesTakeBoundedWork) {
  for (const std::size_t count : {1500U, 20000U}) {
    std::vector<Vec3d> comb;
    for (std::size_t i = 0; i < count / 2; ++i) comb.emplace_back(double(i), i % 2 == 1 ? 1000.0 : 1.0, 0);
    for (std::size_t i = count / 2; i-- > 0;) comb.emplace_back(double(i), 0, 0);
    double twice = 0;
    for (std::size_t i = 0; i < comb.size(); ++i) twice += cross(comb[i], comb[(i + 1) % comb.size()]).z;
    const auto [area, facing] = areas(comb, {0, 0, -1});
    EXPECT_NEAR(area, std::abs(twice) / 2, 1e-3) << count;
    EXPECT_NEAR(facing, std::abs(twice) / 2, 1e-3) << count;
    std::int64_t little = 1000;
    EXPECT_EQ(triangulate_polygon(comb, little).triangles.size(), count - 2) << "a fan of what is left";
    EXPECT_GT(little, -static_cast<std::int64_t>(2 * count)) << "ends soon after its work is used up";
  }
}

}  // namespace
}  // namespace ps::touching_polygons_test
