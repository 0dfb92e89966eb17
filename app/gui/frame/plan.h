#pragma once
#include "gui/panels/pictures/picture_transform.h"

namespace ps::gui {

/// The input of a plan. Lengths are in window pixels.
struct PlanInput {
  Area area;                 ///< that is divided: the window without its menu and status lines
  ImVec2 window{0, 0};       ///< whose share the pictures take
  Vec2i picture{600, 600};   ///< size of A and of B, picture pixels
  bool one_picture = false;  ///< A and B take the place of one, or only one of them is shown
  float scale = 1;           ///< of the type
  float captions = 0;        ///< height of the lines above and below a picture
  float text_width = 0;      ///< at which a lesson's text reads best
  float headline = 0;        ///< height of a stage or drawer that is folded to one line
};

/// Where the tool has its place that a lesson's step is about: nowhere, in one line below the pictures, below or beside
/// them.
enum class StagePlace { none, line, below, beside };

/// How the window is divided in a lesson.
struct LessonPlan {
  Area text, pictures, stage;
  StagePlace place = StagePlace::none;  ///< where the stage lies
  bool shared = false;                  ///< text and stage have one place, for one of them at a time
};

/// At the sides of a region, and above and below a normal one, at scale 1.
inline constexpr double region_padding = 8;

/// Between two pictures, and between them and what is beside them, at scale 1.
inline constexpr float picture_gap = 8, picture_margin = 4;

/// The shares of the window that the pictures keep, 0..1: in a lesson whose step names no tool, below and beside those
/// that it names, and exploring.
inline constexpr double lesson_share = 0.35, below_share = 0.18, beside_share = 0.14, explore_share = 0.30;

/// Room of a tool at scale 1, without its toolbar: its height below the pictures, its width beside them.
inline constexpr float stage_height = 260, stage_width = 590;

/// The text has two widths in a window: one at which it reads best, as long as two square pictures beside it, or in a
/// narrow window one, keep lesson_share; and a narrow one beside a tall tool. The tool has what it needs, but for what
/// the pictures must keep; one that would stand below a single picture stands beside it where there is room. In a
/// narrow window, or with large type, where text, tall tool and pictures do not fit, text and tool share one place.
LessonPlan plan_lesson(const PlanInput& input, StagePlace stage);

/// How the window is divided exploring, below the bar of techniques. `left`, `right` and `bottom` are shares of the
/// area as the document has them, 0 = what suits the window; `bottom` 0 = folded.
struct ExplorePlan {
  float left = 0;    ///< width of the options, or of a lesson's text; 0 while they are folded
  float right = 0;   ///< width of the pixel's story; that of its handle while it is folded
  float bottom = 0;  ///< height of the drawer
};
struct ExploreShares {
  double left = 0, right = 0, bottom = 0;
  bool left_open = false, story_open = true;
};
ExplorePlan plan_explore(const PlanInput& input, const ExploreShares& shares);

}  // namespace ps::gui
