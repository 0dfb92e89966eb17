// The rows of a triangle on the canvas, as the lab prints them and as the fill rule fills them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "base/read_file.h"
#include "frame/display_frame.h"
#include "inspect/canvas_rows.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/run_cli.h"

namespace ps::canvas_rows_test {
namespace {

using test::run_cli;
using test::run_cli_well;

/// LAB 4 prints y, left and right of its triangle.
constexpr std::array<std::array<int, 3>, 11> printed_rows{{{5, 10, 10},
                                                           {6, 9, 10},
                                                           {7, 8, 11},
                                                           {8, 7, 11},
                                                           {9, 6, 12},
                                                           {10, 5, 12},
                                                           {11, 7, 13},
                                                           {12, 9, 13},
                                                           {13, 11, 14},
                                                           {14, 13, 14},
                                                           {15, 15, 15}}};

/// The pixels between the three edges by the plane's definition: a centre is inside where it lies on the same side of
/// all edges, in twice the pixels' whole numbers.
bool strictly_inside(const std::vector<Vec2i>& corner, Vec2i pixel) {
  int left = 0, right = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2i a = corner[k], b = corner[(k + 1) % 3];
    const int side = (b.x - a.x) * (pixel.y - a.y) - (b.y - a.y) * (pixel.x - a.x);
    left += side > 0;
    right += side < 0;
  }
  return left == 3 || right == 3;
}

TEST(CanvasRows, AreThoseOfTheLabAndOfTheFillRule) {
  const Scene scene = load_scene("lab/polygon-rows");
  Settings settings = settings_for(scene);
  const View view{scene.camera, 20, 20};
  Progress progress;
  const auto found = canvas_rows(scene, view, settings, {10, 9}, progress);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].vertices, (std::vector<Vec2i>{{10, 5}, {5, 10}, {15, 15}}));
  std::size_t lab_rows = 0;
  for (const CanvasRow& row : found[0].rows) {
    if (!row.outlined) continue;
    ASSERT_LT(lab_rows, printed_rows.size());
    const auto& [y, left, right] = printed_rows[lab_rows++];
    EXPECT_EQ(row.y, y);
    EXPECT_EQ(row.outlined, (ColumnSpan{left, right}));
  }
  EXPECT_EQ(lab_rows, printed_rows.size());
  for (const FillRule rule : {FillRule::top_left, FillRule::inclusive, FillRule::exclusive}) {
    settings.fill_rule = rule;
    const auto rows = canvas_rows(scene, view, settings, {10, 9}, progress).at(0).rows;
    const auto picture = display_frame(render(scene, view, settings), settings);
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 20; ++x) {
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const CanvasRow& r) { return r.y == y; });
        const bool filled = row != rows.end() && row->filled && x >= row->filled->left && x <= row->filled->right;
        EXPECT_EQ(filled, picture.at(x, y) != (Rgb8{0, 0, 0})) << x << "," << y;
        if (rule == FillRule::exclusive) {
          EXPECT_EQ(filled, strictly_inside(found[0].vertices, {x, y})) << x << "," << y;
        }
      }
  }
}

TEST(CanvasRows, OnlyOfTrianglesAtThePixel) {
  const Scene scene = load_scene("chapters/cgfs_07_filled_triangles/square.scene");
  const Settings settings = settings_for(scene);
  const View view{scene.camera, 40, 40};
  Progress progress;
  EXPECT_EQ(canvas_rows(scene, view, settings, {20, 19}, progress).size(), 2u) << "both have the common edge";
  EXPECT_EQ(canvas_rows(scene, view, settings, {30, 21}, progress).size(), 1u);
  EXPECT_TRUE(canvas_rows(scene, view, settings, {1, 1}, progress).empty());
  Scene far = scene;
  far.canvas_items.edit([](std::vector<CanvasItem>& items) {
    std::get<CanvasTriangle>(items[0]).points[0] = {-1e300, 1e300};
  });
  const auto cut = canvas_rows(far, view, settings, {20, 19}, progress);
  EXPECT_GE(cut.size(), 1u);
  for (const CanvasShapeRows& shape : cut) EXPECT_LE(shape.rows.size(), 40u) << "only the picture's";
}

// A polygon is one shape, with the rows that canvas-fill = rows draws and the colours that are interpolated between.
TEST(CanvasRows, OfAPolygonAreThoseThatAreDrawn) {
  const Scene scene = load_scene("lab/polygons");
  Settings settings = settings_for(scene);
  const View view{scene.camera, 400, 400};
  Progress progress;
  Prepared prepared;
  const Vec2i pixel{310, 100};
  const auto found = canvas_rows(scene, view, settings, pixel, progress);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].item, 1);
  EXPECT_EQ(shape_name(found[0]), "polygon with 4 vertices");
  settings.canvas_fill = CanvasFill::rows;
  int compared = 0;
  for (const CanvasRow& row : found[0].rows) {
    if (!row.outlined || row.y % 9 != 0) continue;
    const int middle = (row.outlined->left + row.outlined->right) / 2;
    const PixelStory story = inspect(scene, view, settings, {middle, row.y}, prepared, progress);
    const PolygonEvent* polygon = nullptr;
    for (const auto* one : events_of<PolygonEvent>(story.events)) polygon = one;
    ASSERT_TRUE(polygon && polygon->row) << row.y;
    EXPECT_EQ(*row.outlined, (ColumnSpan{polygon->row->left, polygon->row->right})) << row.y;
    for (std::size_t end = 0; end < 2; ++end)
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(row.end_colours[end][c], polygon->row->end_colours[end][c], 1e-6) << row.y;
    ++compared;
  }
  EXPECT_GT(compared, 10);
  const auto text = run_cli_well({"inspect", "lab/polygons", "--pixel", "310,100", "--rows"});
  EXPECT_NE(text.out.find("canvas item 1, polygon with 4 vertices, vertices at pixels ("), std::string::npos);
  EXPECT_NE(text.out.find("colour of the left end"), std::string::npos) << text.out;
}

TEST(CanvasRows, CommandLine) {
  const auto text = run_cli_well({"inspect", "lab/polygon-rows", "--pixel", "10,9", "--rows"});
  EXPECT_NE(text.out.find("vertices at pixels (10, 5), (5, 10), (15, 15)"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("      9          6..12"), std::string::npos) << text.out;
  const auto json =
      nlohmann::json::parse(run_cli({"inspect", "lab/polygon-rows", "--pixel", "10,9", "--rows", "--json"}).out);
  std::size_t count = 0;
  for (const auto& row : json["triangles"][0]["rows"])
    if (!row["interpolated"].is_null()) {
      const auto& [y, left, right] = printed_rows.at(count++);
      EXPECT_EQ(row["y"], y);
      EXPECT_EQ(row["interpolated"], nlohmann::json({left, right}));
      EXPECT_EQ(row["end_colours"].size(), 2u);
    }
  EXPECT_EQ(count, printed_rows.size());
  const test::ScratchFolder folder;
  ASSERT_EQ(run_cli({"inspect", "lab/polygon-rows", "--pixel", "10,9", "--rows", "--out", folder.file("rows")}).status,
            0);
  EXPECT_EQ(read_whole_file(folder.file("rows")), text.out);
  EXPECT_EQ(run_cli({"inspect", "lab/polygon-rows", "--pixel", "10,9", "--rows", "--csv"}).status, 2);
  const auto none = run_cli({"inspect", "cgfs/spheres", "--size", "9x9", "--pixel", "3,3", "--rows"});
  EXPECT_EQ(none.status, 2);
  EXPECT_NE(none.err.find("no filled triangle or polygon of the canvas"), std::string::npos) << none.err;
}

}  // namespace
}  // namespace ps::canvas_rows_test
