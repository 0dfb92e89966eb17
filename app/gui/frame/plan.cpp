#include "gui/frame/plan.h"

#include <algorithm>
#include <cmath>

namespace ps::gui {
namespace {

constexpr float grip = 6;              // between regions, at scale 1
constexpr float least_text = 400;      // at scale 1; below it one picture takes the place of two
constexpr float narrowest_text = 290;  // at scale 1
constexpr float least_stage = 4.2f;    // headlines; a lower stage would show no line of its tool
constexpr double spare = 0.001;        // of the window: what rounding may take of the pictures' share
constexpr float beside_text = 0.315f, beside_stage = 0.32f;  // of the width, where a tool is beside one picture
constexpr float least_shared = 0.34f;                        // of the width, for text and tool in one place

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

/// The part of the window, 0..1, that the pictures take in this place: two side by side or stacked, or one.
double share_in(const PlanInput& in, const Area& place) {
  const double aspect = static_cast<double>(in.picture.x) / std::max(in.picture.y, 1);
  const auto pixels = [&](int across, int down) {
    const double width = static_cast<double>(place.width() - between_pictures(in, across)) / across;
    const double all_height = place.height() - in.scale * picture_gap * static_cast<float>(down);
    const double height = all_height / down - in.captions;
    const double fitted = std::max(0.0, std::min(height, width / aspect));
    return across * down * fitted * fitted * aspect;
  };
  const double two = in.one_picture ? 0 : std::max(pixels(2, 1), pixels(1, 2));
  return std::max(pixels(1, 1), two) / (static_cast<double>(in.window.x) * in.window.y);
}

/// The pictures with their share at full height; text and tool have what is left, for one of them at a time.
LessonPlan plan_shared(const PlanInput& in) {
  const Area& area = in.area;
  const Size one = room_for(in, 1, beside_share + 5 * spare), two = room_for(in, 2, beside_share + 5 * spare);
  const bool high = one.height > area.height() && !in.one_picture;
  const float least = std::min(narrowest_text * in.scale, area.width() * least_shared);
  const float rest = area.width() - (high ? two.width : one.width);
  const float end = std::floor(area.min.x + std::clamp(rest, least, std::max(in.text_width, least)));
  const Area column{area.min, {end, area.max.y}};
  return {.text = column, .pictures = {{end, area.min.y}, area.max}, .stage = column, .shared = true};
}

/// Text, one picture and a tool, each as high as the area.
LessonPlan plan_beside(const PlanInput& in) {
  const Area& area = in.area;
  const float between = grip * in.scale;
  const float stage_begin = std::round(area.max.x - area.width() * beside_stage);
  const float most_text = std::min(in.text_width, area.width() * beside_text);
  const float rest = stage_begin - between - area.min.x - room_for(in, 1, beside_share + 5 * spare).width;
  const float text = std::clamp(rest, std::min(narrowest_text * in.scale, most_text), most_text);
  const float text_end = std::floor(area.min.x + text);
  return {.text = {area.min, {text_end, area.max.y}},
          .pictures = {{text_end, area.min.y}, {stage_begin - between, area.max.y}},
          .stage = {{stage_begin, area.min.y}, area.max}};
}

}  // namespace

LessonPlan plan_lesson(const PlanInput& in, StagePlace stage) {
  if (stage == StagePlace::beside) {
    const LessonPlan beside = plan_beside(in);
    return share_in(in, beside.pictures) >= beside_share ? beside : plan_shared(in);
  }
  const Area& area = in.area;
  const float between = grip * in.scale;
  const float height = area.height();
  const Size two = room_for(in, 2, lesson_share + spare), one = room_for(in, 1, lesson_share + 40 * spare);
  // Two pictures beside a readable text; beside a narrow one only where the height leaves one picture too small.
  const float below = stage == StagePlace::below ? in.headline + between : 0;
  const float beside_two = area.width() - two.width;
  const bool one_fits = one.height + below <= height;
  const float wanted_text = std::min((one_fits ? least_text : narrowest_text) * in.scale, in.text_width);
  const bool side_by_side = !in.one_picture && beside_two >= wanted_text && two.height + below <= height;
  float text = std::min(in.text_width, area.width() - (side_by_side ? two.width : one.width));
  text = std::floor(std::max(text, std::min(narrowest_text * in.scale, area.width() * 0.4f)));

  LessonPlan plan;
  plan.text = {area.min, {area.min.x + text, area.max.y}};
  const Area rest{{area.min.x + text, area.min.y}, area.max};
  plan.pictures = rest;
  plan.stage = {{rest.min.x, rest.max.y}, rest.max};
  if (stage == StagePlace::none) return plan;
  const float wanted = filled_height(in, side_by_side ? 2 : 1, rest.width());
  plan.pictures.max.y = std::round(rest.min.y + std::min(wanted, height - below));
  plan.stage.min.y = plan.pictures.max.y + between;
  plan.folded = plan.stage.height() < least_stage * in.headline;
  if (plan.folded) {  // the pictures may as well have what a stage cannot use
    plan.pictures.max.y = std::round(rest.max.y - below);
    plan.stage.min.y = plan.pictures.max.y + between;
  }
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
