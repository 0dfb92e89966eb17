// Triangles and convex polygons on the canvas filled row by row (LAB 4), against a fan of triangles with edge
// functions, against the same rows in double by hand, and against the lab's printed rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>

#include "options/scene_settings.h"
#include "raster/clear/polygon_rows.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/seeded_random.h"

namespace ps::canvas_fill_test {
namespace {

constexpr int columns = 60, rows = 44;

/// The canvas point in the middle of a pixel (array position).
Vec2d middle_of(Vec2i pixel) {
  const int x = pixel.x - columns / 2, y = rows - rows / 2 - 1 - pixel.y;
  return {x + 0.5, y + 0.5};
}

Settings settings_with(CanvasFill fill, Precision precision = Precision::float32) {
  Settings settings{.renderer = Renderer::rasterizer};
  settings.canvas_fill = fill;
  settings.precision = precision;
  settings.fill_rule = FillRule::inclusive;
  return settings;
}

Scene scene_of(const std::vector<CanvasItem>& items) {
  Scene scene;
  scene.background = {0, 0, 0};
  scene.canvas_items = Part<std::vector<CanvasItem>>(items);
  return scene;
}

Frame drawn(const Scene& scene, const Settings& settings, std::optional<TileRect> region = {}) {
  return render(scene, {scene.camera, columns, rows}, settings, request_for(Channel::overdraw, region));
}

double turn(Vec2i a, Vec2i b, Vec2i c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// The hull of some pixels, from a random one of its vertices on, either way round; empty if they lie on a line.
std::vector<Vec2i> random_hull(std::mt19937& random, int count, int reach_x, int reach_y) {
  const auto pick = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  std::vector<Vec2i> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) points.push_back({pick(0, reach_x), pick(0, reach_y)});
  std::sort(points.begin(), points.end(), [](Vec2i a, Vec2i b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Vec2i> hull;
  for (const bool back : {false, true}) {
    const std::size_t start = hull.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2i p = back ? points[points.size() - 1 - i] : points[i];
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
  }
  if (hull.size() < 3) return {};
  std::rotate(hull.begin(), hull.begin() + pick(0, static_cast<int>(hull.size()) - 1), hull.end());
  if (pick(0, 1) == 1) std::reverse(hull.begin(), hull.end());
  return hull;
}

/// Red and green say where a point is, so that a picture shows which point of the polygon each pixel was given.
Vec3d place_colour(Vec2i pixel, double blue) { return {pixel.x / 64.0, pixel.y / 64.0, blue}; }

CanvasPolygon polygon_of(const std::vector<Vec2i>& pixels, const std::vector<double>& blue) {
  CanvasPolygon polygon;
  for (std::size_t i = 0; i < pixels.size(); ++i)
    polygon.vertices.push_back({middle_of(pixels[i]), place_colour(pixels[i], blue[i])});
  return polygon;
}

/// How far a point lies outside the polygon, in pixels; not above 0 inside.
double outside(const std::vector<Vec2i>& hull, const Vec2d& p) {
  double sense = 0, most = -1e9;
  for (std::size_t i = 0; i < hull.size(); ++i) sense += turn(hull[0], hull[i], hull[(i + 1) % hull.size()]);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2d a(hull[i]), b(hull[(i + 1) % hull.size()]), e = b - a;
    const double away = (e.x * (p.y - a.y) - e.y * (p.x - a.x)) / std::hypot(e.x, e.y);
    most = std::max(most, sense > 0 ? -away : away);
  }
  return most;
}

TEST(CanvasFill, DrawsTheRowsThatTheLabPrints) {
  const std::map<int, std::array<int, 2>> printed{{5, {10, 10}},  {6, {9, 10}},   {7, {8, 11}},  {8, {7, 11}},
                                                  {9, {6, 12}},   {10, {5, 12}},  {11, {7, 13}}, {12, {9, 13}},
                                                  {13, {11, 14}}, {14, {13, 14}}, {15, {15, 15}}};
  const Scene scene = load_scene("lab/polygon-rows");
  Settings settings = settings_for(scene);
  settings.canvas_fill = CanvasFill::rows;
  const Frame frame = render(scene, {scene.camera, 20, 20}, settings, request_for(Channel::overdraw));
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) {
      const auto row = printed.find(y);
      const bool filled = row != printed.end() && x >= row->second[0] && x <= row->second[1];
      EXPECT_EQ(frame.overdraw.at(x, y), filled ? 1u : 0u) << x << "," << y;
    }
}

// With vertices in the middle of pixels the fan covers the pixels whose middle lies in the polygon. The rows hold all
// of them, and beside them only pixels with a point of the polygon less than a pixel to the right and below; the colour
// of every pixel is that of such a point.
TEST(CanvasFill, RowsHoldTheFanAndEachPixelHasTheColourOfAPointInIt) {
  test::SeededRandom random;
  int polygons = 0, more = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto hull = random_hull(random, 3 + trial % 9, columns - 1, rows - 1);
    if (hull.empty()) continue;
    ++polygons;
    // A plane, so that the fan gives its exact value everywhere.
    const double gx = random.between(0, 1) - 0.5, gy = random.between(0, 1) - 0.5;
    std::vector<double> blue;
    blue.reserve(hull.size());
    for (const Vec2i& v : hull) blue.push_back(0.5 + (gx * v.x + gy * v.y) / 64);
    const Scene scene = scene_of({polygon_of(hull, blue)});
    const Frame by_rows = drawn(scene, settings_with(CanvasFill::rows));
    const Frame fan = drawn(scene, settings_with(CanvasFill::edges));
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        const bool in_rows = by_rows.overdraw.at(x, y) > 0, in_fan = fan.overdraw.at(x, y) > 0;
        ASSERT_FALSE(in_fan && !in_rows) << x << "," << y;
        ASSERT_LE(by_rows.overdraw.at(x, y), 1u) << "each pixel once";
        if (!in_rows) continue;
        more += in_fan ? 0 : 1;
        const Vec3d c(by_rows.colour.at(x, y));
        const Vec2d point(c.x * 64, c.y * 64), offset = point - Vec2d(x, y);
        ASSERT_GT(offset.x, -1e-3);
        ASSERT_LT(offset.x, 1);
        ASSERT_GT(offset.y, -1e-3);
        ASSERT_LT(offset.y, 1);
        ASSERT_LT(outside(hull, point), 1e-3) << x << "," << y;
        ASSERT_NEAR(c.z, 0.5 + (gx * point.x + gy * point.y) / 64, 1e-5);
        if (in_fan) {
          const Vec3d of_fan(fan.colour.at(x, y));
          ASSERT_NEAR(c.z, of_fan.z + (gx * offset.x + gy * offset.y) / 64, 1e-5) << x << "," << y;
        }
      }
  }
  EXPECT_GT(polygons, 200);
  EXPECT_GT(more, 1000);
}

/// The lab's way by hand, in double: along the edges step by step, then along each row.
std::map<std::pair<int, int>, Vec3d> by_hand(const std::vector<Vec2i>& pixels, const std::vector<Vec3d>& colours) {
  struct End {
    int x = 0;
    Vec3d colour{0, 0, 0};
  };
  std::map<int, std::pair<End, End>> ends;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::size_t next = (i + 1) % pixels.size();
    const Vec2i a = pixels[i], b = pixels[next];
    const int steps = std::max(std::abs(b.x - a.x), std::abs(b.y - a.y));
    for (int s = 0; s <= steps; ++s) {
      const auto down = [&](int from, int to) {
        const int scaled = (to - from) * s, divisor = std::max(steps, 1);
        return from + scaled / divisor - (scaled % divisor < 0 ? 1 : 0);
      };
      const double t = steps == 0 ? 0 : static_cast<double>(s) / steps;
      const End end{down(a.x, b.x), colours[i] * (1 - t) + colours[next] * t};
      const auto [row, fresh] = ends.try_emplace(down(a.y, b.y), end, end);
      if (fresh) continue;
      if (end.x < row->second.first.x) row->second.first = end;
      if (end.x > row->second.second.x) row->second.second = end;
    }
  }
  std::map<std::pair<int, int>, Vec3d> drawn;
  for (const auto& [y, row] : ends)
    for (int x = row.first.x; x <= row.second.x; ++x) {
      const double t =
          row.first.x == row.second.x ? 0 : static_cast<double>(x - row.first.x) / (row.second.x - row.first.x);
      drawn[{x, y}] = row.first.colour * (1 - t) + row.second.colour * t;
    }
  return drawn;
}

// Colours that lie in no plane: neither a fan nor rows can be right, and they differ.
TEST(CanvasFill, BothPrecisionsGiveTheRowsByHandAndAFanDiffers) {
  test::SeededRandom random;
  double farthest_from_fan = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const auto hull = random_hull(random, 4 + trial % 7, columns - 1, rows - 1);
    if (hull.empty()) continue;
    CanvasPolygon polygon;
    std::vector<Vec3d> colours;
    for (const Vec2i& pixel : hull) {
      const double h = random.between(0, 1);
      const Vec3d colour{random.between(0, 1), random.between(0, 1), random.between(0, 1)};
      polygon.vertices.push_back({middle_of(pixel), colour, h});
      colours.push_back(colour * h);
    }
    const Scene scene = scene_of({polygon});
    const auto expected = by_hand(hull, colours);
    const Frame single = drawn(scene, settings_with(CanvasFill::rows));
    const Frame twice = drawn(scene, settings_with(CanvasFill::rows, Precision::float64));
    const Frame fan = drawn(scene, settings_with(CanvasFill::edges));
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        const auto by = expected.find({x, y});
        ASSERT_EQ(single.overdraw.at(x, y), by == expected.end() ? 0u : 1u) << x << "," << y;
        ASSERT_EQ(twice.overdraw.at(x, y), single.overdraw.at(x, y));
        if (by == expected.end()) continue;
        for (int channel = 0; channel < 3; ++channel) {
          ASSERT_NEAR(single.colour.at(x, y)[channel], by->second[channel], 1e-6);
          ASSERT_NEAR(twice.colour_double.at(x, y)[channel], by->second[channel], 1e-14);
          if (fan.overdraw.at(x, y) > 0)
            farthest_from_fan =
                std::max(farthest_from_fan, std::abs(fan.colour.at(x, y)[channel] - by->second[channel]));
        }
      }
  }
  EXPECT_GT(farthest_from_fan, 0.1);
}

// Rows are asked for tile by tile; neither tiles nor threads nor a rectangle may show.
TEST(CanvasFill, TilesThreadsAndRectanglesDoNotShow) {
  const Scene scene = load_scene("lab/polygons");
  Settings settings = settings_for(scene);
  settings.canvas_fill = CanvasFill::rows;
  const View view{scene.camera, 400, 400};
  settings.threads = 1;
  const Frame whole = render(scene, view, settings);
  for (const int threads : {2, 7}) {
    settings.threads = threads;
    const Frame again = render(scene, view, settings);
    EXPECT_TRUE(again.colour == whole.colour) << threads;
    EXPECT_EQ(again.counters[Counter::fragments], whole.counters[Counter::fragments]);
  }
  const Frame part = render(scene, view, settings, request_for(Channel::none, TileRect{37, 41, 255, 190}));
  for (int y = 41; y < 190; ++y)
    for (int x = 37; x < 255; ++x) ASSERT_EQ(part.colour.at(x, y), whole.colour.at(x, y));
}

TEST(CanvasFill, TheStorySaysWhatTheKernelInterpolated) {
  const Scene scene = load_scene("lab/polygons");
  Settings settings = settings_for(scene);
  settings.canvas_fill = CanvasFill::rows;
  const View view{scene.camera, 400, 400};
  const Frame frame = render(scene, view, settings);
  const Vec2i pixel{310, 100};  // in the polygon with four colours
  const PixelStory story = inspect(scene, view, settings, pixel);
  EXPECT_EQ(Vec3f(story.linear), frame.colour.at(pixel.x, pixel.y));
  const PolygonEvent* found = nullptr;
  for (const auto* polygon : events_of<PolygonEvent>(story.events)) found = polygon;
  ASSERT_TRUE(found && found->row);
  EXPECT_EQ(found->item, 1);
  EXPECT_EQ(found->fill, CanvasFill::rows);
  ASSERT_EQ(found->vertices.size(), 4u);
  std::vector<Vec2i> vertices;
  for (const Vec2d& v : found->vertices) vertices.push_back(Vec2i(v));
  const auto expected = raster::polygon_rows(vertices, {pixel.y, pixel.y});
  ASSERT_EQ(expected.size(), 1u);
  EXPECT_EQ(found->row->left, expected[0].left.x);
  EXPECT_EQ(found->row->right, expected[0].right.x);
  EXPECT_EQ(found->row->edges, (std::array{expected[0].left.edge, expected[0].right.edge}));
  EXPECT_EQ(found->row->colour, story.linear);
  const PolygonRowSpan& row = *found->row;
  const Vec3d mixed = row.end_colours[0] * (1 - row.along_row) + row.end_colours[1] * row.along_row;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(mixed[c], story.linear[c], 1e-6);
  EXPECT_EQ(story.verdict.find("polygon 1 on the canvas won, row 100 from x = "), 0u) << story.verdict;
  // The sum names both ends.
  int ends = 0;
  for (const LedgerLine& line : story.ledger) ends += line.term.find("end of the row") != std::string::npos ? 1 : 0;
  EXPECT_EQ(ends, 2);
  // By edge functions the same polygon reports the triangles that it is filled as.
  settings.canvas_fill = CanvasFill::edges;
  const PixelStory fan = inspect(scene, view, settings, pixel);
  int polygons = 0, fragments = 0;
  for (std::size_t i = 0; i < fan.events.size(); ++i) {
    const auto* polygon = std::get_if<PolygonEvent>(&fan.events[i].data);
    if (!polygon) continue;
    ++polygons;
    EXPECT_FALSE(polygon->row);
    fragments += static_cast<int>(events_below<FragmentEvent>(fan.events, static_cast<int>(i)).size());
  }
  EXPECT_EQ(polygons, 1);
  EXPECT_EQ(fragments, 1);
  EXPECT_EQ(fan.verdict.find("polygon 1 on the canvas won"), 0u) << fan.verdict;
}

// A vertex that is far away is cut off; what is seen stays. Edge functions draw nothing with one beyond all floats.
TEST(CanvasFill, FarVerticesAreDefined) {
  std::optional<Frame> nearer;
  for (const double far : {7e4, 1e9, 1e300}) {
    CanvasPolygon polygon;
    for (const Vec2d& point : {Vec2d{-20, -15}, {far, -15}, {far, far}, {-20, 10}})
      polygon.vertices.push_back({point, {1, 1, 1}});
    const Frame by_rows = drawn(scene_of({polygon}), settings_with(CanvasFill::rows));
    const Frame fan = drawn(scene_of({polygon}), settings_with(CanvasFill::edges));
    int covered = 0, differ = 0;
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        covered += static_cast<int>(by_rows.overdraw.at(x, y));
        differ += by_rows.overdraw.at(x, y) != fan.overdraw.at(x, y) ? 1 : 0;
      }
    EXPECT_GT(covered, 800) << far;
    if (nearer) {
      EXPECT_TRUE(by_rows.overdraw == nearer->overdraw) << far;
    }
    nearer = by_rows;
    if (far > 1e30) continue;
    EXPECT_LT(differ, 3 * (rows + columns)) << far << ": a border of a pixel, and what snapping moves";
  }
}

// All edges are inside, so two shapes that share one draw it twice; the fill rule draws it once.
TEST(CanvasFill, NeighboursOverlapByRowsAlone) {
  const std::vector<Vec2i> left{{5, 5}, {30, 5}, {30, 35}, {5, 35}}, right{{30, 5}, {55, 5}, {55, 35}, {30, 35}};
  std::vector<CanvasItem> items;
  for (const auto& pixels : {left, right}) items.emplace_back(polygon_of(pixels, {0.5, 0.5, 0.5, 0.5}));
  Settings settings = settings_with(CanvasFill::rows);
  const Frame by_rows = drawn(scene_of(items), settings);
  settings = settings_with(CanvasFill::edges);
  settings.fill_rule = FillRule::top_left;
  const Frame fan = drawn(scene_of(items), settings);
  for (int y = 6; y < 35; ++y) {
    EXPECT_EQ(by_rows.overdraw.at(30, y), 2u);
    EXPECT_EQ(fan.overdraw.at(30, y), 1u);
  }
}

}  // namespace
}  // namespace ps::canvas_fill_test
