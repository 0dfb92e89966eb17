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

/// Where the tool has its place that a lesson's step is about.
enum class StagePlace { none, below, beside };

/// How the window is divided in a lesson.
struct LessonPlan {
  Area text, pictures, stage;
  bool folded = false;  ///< the stage has room for its headline alone
  bool shared = false;  ///< text and stage have one place, for one of them at a time
};

/// Between two pictures, and between them and what is beside them, at scale 1.
inline constexpr float picture_gap = 8, picture_margin = 4;

/// The shares of the window that the pictures keep, 0..1: in a lesson, there beside a tall tool, and exploring.
inline constexpr double lesson_share = 0.35, beside_share = 0.30, explore_share = 0.30;

/// The text as wide as it reads best, unless the pictures, side by side or as one, would take less than lesson_share of
/// the window. What height they leave is the stage's below them; beside them it takes the place of one. Beside a tall
/// tool the text gives way until the pictures have beside_share. In a narrow window, or with large type, where text,
/// tool and pictures with that share do not fit, text and tool share one place.
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
