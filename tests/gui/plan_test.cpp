// How a lesson's window is divided: the share of the window that pictures can have, whatever the screen, the step's
// tool and the shape of the pictures.
#include "gui/frame/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace ps::gui::plan_test {
namespace {

struct Case {
  float width, height, scale;
};

PlanInput input_of(const Case& window, Vec2i picture) {
  PlanInput in;
  in.window = {window.width, window.height};
  in.area = {{0, 28 * window.scale}, {window.width, window.height - 27 * window.scale}};
  in.picture = picture;
  in.scale = window.scale;
  in.captions = 41 * window.scale;
  in.text_width = 520 * window.scale;
  in.headline = 31 * window.scale;
  return in;
}

/// Share of the window that one picture takes in a place, or the two of them beside or below one another.
double best_share(const PlanInput& in, const Area& place) {
  const double aspect = static_cast<double>(in.picture.x) / in.picture.y;
  const double margin = 2.0 * picture_margin * in.scale, gap = picture_gap * in.scale;
  const auto pixels = [&](double width, double height) {
    const double h = std::min(height, width / aspect);
    return std::max(h, 0.0) * std::max(h, 0.0) * aspect;
  };
  const double width = place.width() - margin, height = place.height();
  const double one = pixels(width, height - in.captions);
  const double two = std::max(2 * pixels((width - gap) / 2, height - in.captions),
                              2 * pixels(width, (height - gap) / 2 - in.captions));
  return 100 * std::max(one, two) / (static_cast<double>(in.window.x) * in.window.y);
}

bool inside(const Area& part, const Area& whole) {
  return part.min.x >= whole.min.x && part.min.y >= whole.min.y && part.max.x <= whole.max.x &&
         part.max.y <= whole.max.y && part.width() > 0 && part.height() > 0;
}

bool apart(const Area& a, const Area& b) {
  return a.max.x <= b.min.x || b.max.x <= a.min.x || a.max.y <= b.min.y || b.max.y <= a.min.y;
}

const std::vector<Case> windows{{1024, 768, 1},    {1366, 768, 1},    {1920, 1080, 1},    {3840, 2160, 2},
                                {1024, 768, 1.5f}, {1366, 768, 1.5f}, {1920, 1080, 1.5f}, {3840, 2160, 3}};

/// Percent of the window that square pictures must have.
double least_share(StagePlace stage, bool one_picture, bool cramped) {
  switch (stage) {
  case StagePlace::none:
  case StagePlace::line:
    return cramped ? 30 : 35;
  case StagePlace::below:
    return one_picture ? 14 : 17.5;
  case StagePlace::beside:
    break;
  }
  return 14;
}

TEST(LessonPlan, SquarePicturesHaveTheirShareBelowAndBesideTools) {
  for (const Case& window : windows)
    for (const StagePlace stage : {StagePlace::none, StagePlace::line, StagePlace::below, StagePlace::beside}) {
      SCOPED_TRACE(std::to_string(window.width) + "x" + std::to_string(window.height) + " type " +
                   std::to_string(window.scale) + " stage " + std::to_string(static_cast<int>(stage)));
      PlanInput in = input_of(window, {600, 600});
      for (const bool one_picture : {false, true}) {
        in.one_picture = one_picture;
        const LessonPlan plan = plan_lesson(in, stage);
        EXPECT_TRUE(inside(plan.text, in.area));
        EXPECT_TRUE(inside(plan.pictures, in.area));
        EXPECT_TRUE(apart(plan.text, plan.pictures));
        if (stage != StagePlace::none) {
          EXPECT_TRUE(inside(plan.stage, in.area));
          const bool one_place = plan.text.max.x == plan.stage.max.x && plan.text.height() == plan.stage.height();
          EXPECT_TRUE(plan.shared ? one_place : apart(plan.text, plan.stage));
          EXPECT_TRUE(apart(plan.pictures, plan.stage));
        }
        // The captions of large type on a small screen take more.
        const bool cramped = window.scale > 1 && window.width < 1400;
        EXPECT_EQ(plan.shared, (cramped || window.width < 1200) && stage == StagePlace::beside);
        EXPECT_GE(best_share(in, plan.pictures), least_share(stage, one_picture, cramped));
      }
    }
}

// Whatever a step shows, and whatever the shape of its pictures.
TEST(LessonPlan, TheTextHasTwoWidthsInAWindow) {
  for (const Case& window : windows) {
    std::set<float> widths;
    for (const Vec2i picture : {Vec2i{600, 600}, Vec2i{800, 450}, Vec2i{300, 600}})
      for (const bool one_picture : {false, true})
        for (const StagePlace stage : {StagePlace::none, StagePlace::line, StagePlace::below, StagePlace::beside}) {
          PlanInput in = input_of(window, picture);
          in.one_picture = one_picture;
          widths.insert(plan_lesson(in, stage).text.width());
        }
    EXPECT_LE(widths.size(), 2u) << window.width << " type " << window.scale;
  }
}

/// 24 lines of code in small type are 24 times 18 high, at scale 1.
TEST(LessonPlan, TheShareIsKeptForPicturesOfAnyShapeInLargeType) {
  for (const Vec2i picture : {Vec2i{600, 600}, Vec2i{800, 450}, Vec2i{300, 600}})
    for (const Case& window : {Case{1024, 768, 1.5f}, Case{1366, 768, 1.5f}, Case{1366, 768, 1.25f}}) {
      SCOPED_TRACE(std::to_string(picture.x) + " wide at " + std::to_string(window.width) + " type " +
                   std::to_string(window.scale));
      const PlanInput in = input_of(window, picture);
      const LessonPlan plan = plan_lesson(in, StagePlace::beside);
      EXPECT_TRUE(inside(plan.pictures, in.area) && inside(plan.stage, in.area));
      EXPECT_TRUE(apart(plan.pictures, plan.stage));
      EXPECT_GE(best_share(in, plan.pictures), 14);
      if (!plan.shared) continue;
      EXPECT_GE(plan.stage.height(), 24 * 18 * window.scale);
      EXPECT_GE(plan.stage.width(), 0.33f * window.width);
    }
}

TEST(LessonPlan, AToolKeepsItsRoom) {
  constexpr float padding = 16, toolbar = 62;
  PlanInput in = input_of({1366, 768, 1}, {600, 600});
  const LessonPlan wide = plan_lesson(in, StagePlace::beside), below = plan_lesson(in, StagePlace::below);
  EXPECT_GE(wide.stage.width(), 590 + padding);
  EXPECT_GE(wide.stage.height(), 600 + padding + toolbar);
  for (const Case& window : {Case{1280, 800, 1}, Case{1366, 768, 1}, Case{1920, 1080, 1.25f}})
    EXPECT_GE(plan_lesson(input_of(window, {600, 600}), StagePlace::beside).text.width(), (340 + 16) * window.scale)
        << "its lines, and the gutter to the pictures";
  EXPECT_EQ(below.place, StagePlace::below);
  EXPECT_GE(below.stage.width(), 800 + padding);
  EXPECT_GE(below.stage.height(), 260 + padding + toolbar);
  // A single picture above the tool would be too small.
  in.one_picture = true;
  EXPECT_EQ(plan_lesson(in, StagePlace::below).place, StagePlace::beside);
  const LessonPlan narrow = plan_lesson(input_of({1024, 768, 1}, {600, 600}), StagePlace::beside);
  EXPECT_GE(narrow.stage.width(), 590);
  EXPECT_GE(narrow.stage.height(), 24 * 18);
  EXPECT_TRUE(narrow.shared) << "beside one another, text and tool would be too narrow";
}

/// Messages can leave less than no room for the rest of the window.
TEST(Plan, AnAreaWithoutRoomHasAPlan) {
  for (const float height : {0.0f, -300.0f, 5.0f}) {
    PlanInput in;
    in.area = {{0, 0}, {1366, height}};
    in.headline = 30;
    const ExplorePlan plan =
        plan_explore(in, {.left = 0.2, .right = 0.2, .bottom = 0.3, .left_open = true, .story_open = false});
    EXPECT_EQ(plan.bottom, 30) << height;
  }
}

}  // namespace
}  // namespace ps::gui::plan_test
