#include "gui/frame/plan.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ps::gui {
namespace {

constexpr float grip = 6;               // between regions, at scale 1
constexpr float least_text = 400;       // at scale 1; below it one picture takes the place of two
constexpr float narrowest_text = 290;   // at scale 1
constexpr double spare = 0.001;         // of the window: what rounding may take of the pictures' share
constexpr float beside_text = 356;      // at scale 1, beside a tall tool, with 16 to the pictures
constexpr float least_beside = 420;     // at scale 1, for that tool
constexpr float beside_growth = 0.38f;  // share of the width: a wide window has more for it
constexpr float most_pictures = 0.6f;   // share of the height, above a tool
constexpr float stage_lines = 2.25f;    // headlines, above a tool for its controls
constexpr float margin = static_cast<float>(region_padding);

// The pixel's story, at scale 1: in a window so narrow it is 240 wide, in one of 1366 it is 390.
constexpr float narrow_story = 240, narrow_window = 1024, widest_story = 440;
constexpr float story_growth = (390 - narrow_story) / (1366 - narrow_window);

struct Size {
  float width = 0, height = 0;
};

/// The part of a width that is not picture.
float between_pictures(const PlanInput& in, int count) {
  return in.scale * (picture_gap * static_cast<float>(count - 1) + 2 * picture_margin);
}

/// The place that `count` pictures side by side need to take `share` of the window.
Size room_for(const PlanInput& in, int count, double share) {
  const double aspect = static_cast<double>(in.picture.x) / std::max(in.picture.y, 1);
  const double pixels = share * in.window.x * in.window.y / count;
  const double height = std::sqrt(pixels / aspect), width = height * aspect;
  return {static_cast<float>(width) * static_cast<float>(count) + between_pictures(in, count),
          static_cast<float>(height) + in.captions + picture_gap * in.scale};
}

/// The height that pictures fill in this width, with their captions.
float filled_height(const PlanInput& in, int count, float width) {
  const float each = (width - between_pictures(in, count)) / static_cast<float>(count);
  return each * static_cast<float>(in.picture.y) / static_cast<float>(std::max(in.picture.x, 1)) + in.captions +
         picture_gap * in.scale;
}

/// The text's width where no tall tool is beside it, the same for all steps: beside two square pictures, or in a narrow
/// window beside one.
float wide_column(PlanInput in) {
  in.picture = {1, 1};
  const Size two = room_for(in, 2, lesson_share + spare), one = room_for(in, 1, lesson_share + 40 * spare);
  const float width = in.area.width(), height = in.area.height(), beside_two = width - two.width;
  // Beside a narrow text only where the height leaves one picture too small.
  const float wanted = std::min((one.height <= height ? least_text : narrowest_text) * in.scale, in.text_width);
  const bool side_by_side = beside_two >= wanted && two.height <= height;
  const float text = std::min(in.text_width, side_by_side ? beside_two : width - one.width);
  return std::floor(std::max(text, std::min(narrowest_text * in.scale, width * 0.4f)));
}

/// The tool has what it needs of the width, text and tool one after the other; the pictures have the rest, which does
/// not depend on their shape.
LessonPlan plan_shared(PlanInput in) {
  in.picture = {1, 1};
  const Area& area = in.area;
  const float most = area.width() - room_for(in, 1, beside_share + 4 * spare).width;
  const float end =
      area.min.x + std::floor(std::max(std::min((stage_width + 2 * margin) * in.scale, most), area.width() * 0.34f));
  const Area column{area.min, {end, area.max.y}};
  return {.text = column,
          .pictures = {{end, area.min.y}, area.max},
          .stage = column,
          .place = StagePlace::beside,
          .shared = true};
}

/// Text, pictures and a tool, each as high as the area; empty where the tool would be too narrow.
std::optional<LessonPlan> plan_beside(PlanInput in) {
  in.picture = {1, 1};  // wide ones come below one another, or are smaller
  const Area& area = in.area;
  const float between = grip * in.scale, text = beside_text * in.scale;
  const float most = area.width() - text - between - room_for(in, 1, beside_share + 4 * spare).width;
  const float wanted = std::max((stage_width + 2 * margin) * in.scale, area.width() * beside_growth);
  const float stage = std::floor(std::min(wanted, most));
  if (stage < least_beside * in.scale) return {};
  const float text_end = std::floor(area.min.x + text), stage_begin = area.max.x - stage;
  return LessonPlan{.text = {area.min, {text_end, area.max.y}},
                    .pictures = {{text_end, area.min.y}, {stage_begin - between, area.max.y}},
                    .stage = {{stage_begin, area.min.y}, area.max},
                    .place = StagePlace::beside};
}

}  // namespace

LessonPlan plan_lesson(const PlanInput& in, StagePlace stage) {
  const int count = in.one_picture ? 1 : 2;
  const Area& area = in.area;
  const float between = grip * in.scale;
  const float tool = stage_height * in.scale + stage_lines * in.headline + 2 * margin * in.scale;
  const bool low = area.height() - between - tool < room_for(in, 1, beside_share).height;
  if (stage == StagePlace::beside || (stage == StagePlace::below && in.one_picture && low))
    if (const auto beside = plan_beside(in)) return *beside;
  if (stage == StagePlace::beside) return plan_shared(in);

  const float text_end = area.min.x + wide_column(in);
  LessonPlan plan{.text = {area.min, {text_end, area.max.y}},
                  .pictures = {{text_end, area.min.y}, area.max},
                  .stage = {{text_end, area.max.y}, area.max},
                  .place = stage};
  if (stage == StagePlace::none) return plan;
  const float width = plan.pictures.width();
  const float least = std::min(room_for(in, count, in.one_picture ? beside_share : below_share).height,
                               filled_height(in, count, width));
  const float most = area.height() - between - (stage == StagePlace::line ? in.headline : tool);
  const float wanted = stage == StagePlace::line ? most : std::min(most, filled_height(in, count, width));
  plan.pictures.max.y = std::round(area.min.y + std::max(wanted, std::min(least, area.height() * most_pictures)));
  plan.stage.min.y = plan.pictures.max.y + between;
  return plan;
}

ExplorePlan plan_explore(const PlanInput& in, const ExploreShares& shares) {
  // Little or nothing is left beside tall messages.
  const float width = std::max(in.area.width(), 0.0f), height = std::max(in.area.height(), 0.0f);
  const float least_left = std::min(180 * in.scale, width * 0.3f),
              least_right = std::min(180 * in.scale, width * 0.24f);
  // They grow with the window only so far that the pictures keep their share.
  const float own_left = std::clamp(width * 0.183f, std::min(220 * in.scale, width * 0.24f), 300 * in.scale);
  const float own_right = std::clamp(narrow_story * in.scale + (width - narrow_window * in.scale) * story_growth,
                                     std::min(narrow_story * in.scale, width * 0.24f), widest_story * in.scale);
  ExplorePlan plan;
  if (shares.left_open) {
    plan.left = shares.left > 0 ? static_cast<float>(shares.left) * width : own_left;
    plan.left = std::round(std::clamp(plan.left, least_left, width * 0.5f));
  }
  plan.right = in.headline;
  if (shares.story_open) {
    plan.right = shares.right > 0 ? static_cast<float>(shares.right) * width : own_right;
    plan.right = std::round(std::clamp(plan.right, least_right, width * 0.5f));
  }
  plan.bottom = shares.bottom > 0 ? static_cast<float>(shares.bottom) * height : in.headline;
  plan.bottom = std::round(std::clamp(plan.bottom, in.headline, std::max(in.headline, height * 0.7f)));
  return plan;
}

}  // namespace ps::gui
