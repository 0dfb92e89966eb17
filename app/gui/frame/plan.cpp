#include "gui/frame/plan.h"

#include <algorithm>
#include <cmath>

namespace ps::gui {
namespace {

constexpr float gap = 10;              // between two pictures, and around them, at scale 1
constexpr float grip = 6;              // between regions
constexpr float least_text = 400;      // at scale 1; below it one picture takes the place of two
constexpr float narrowest_text = 290;  // at scale 1
constexpr float least_stage = 4.2f;    // headlines; a lower stage would show no line of its tool
constexpr double spare = 0.01;         // of the window: what rounding and margins may take of the pictures' share

struct Size {
  float width = 0, height = 0;
};

/// The place that `count` pictures side by side need to take `share` of the window.
Size room_for(const PlanInput& in, int count, double share) {
  const double aspect = static_cast<double>(in.picture.x) / std::max(in.picture.y, 1);
  const double pixels = share * in.window.x * in.window.y / count;
  const double height = std::sqrt(pixels / aspect), width = height * aspect;
  const float space = gap * in.scale;
  return {static_cast<float>(width) * static_cast<float>(count) + space * static_cast<float>(count + 1),
          static_cast<float>(height) + in.captions + space};
}

/// The height that pictures fill in this width, with their captions.
float filled_height(const PlanInput& in, int count, float width) {
  const float space = gap * in.scale;
  const float each = (width - space * static_cast<float>(count + 1)) / static_cast<float>(count);
  return each * static_cast<float>(in.picture.y) / static_cast<float>(std::max(in.picture.x, 1)) + in.captions + space;
}

}  // namespace

LessonPlan plan_lesson(const PlanInput& in, PanelHeight stage) {
  const Area& area = in.area;
  const float between = grip * in.scale;
  const float height = area.height();
  const Size two = room_for(in, 2, lesson_share + spare), one = room_for(in, 1, lesson_share + 4 * spare);
  // Two pictures beside a readable text; beside a narrow one only where the height leaves one picture too small.
  const float beside_two = area.width() - two.width - between;
  const bool one_fits = one.height + in.headline + between <= height;
  const float wanted_text = std::min((one_fits ? least_text : narrowest_text) * in.scale, in.text_width);
  const bool beside =
      stage == PanelHeight::strip && beside_two >= wanted_text && two.height + in.headline + between <= height;
  const float pictures = stage == PanelHeight::tall ? area.width() * 0.64f : beside ? two.width : one.width;
  float text = std::min(in.text_width, area.width() - pictures - between);
  text = std::round(std::max(text, std::min(narrowest_text * in.scale, area.width() * 0.4f)));

  LessonPlan plan;
  plan.text = {area.min, {area.min.x + text, area.max.y}};
  const Area rest{{area.min.x + text + between, area.min.y}, area.max};
  if (stage == PanelHeight::tall) {
    const float middle = std::round((rest.min.x + rest.max.x) / 2);
    plan.pictures = {rest.min, {middle - between / 2, rest.max.y}};
    plan.stage = {{middle + between / 2, rest.min.y}, rest.max};
    return plan;
  }
  const float wanted = filled_height(in, beside ? 2 : 1, rest.width());
  const float most = height - in.headline - between;
  const float bottom = std::round(rest.min.y + std::min(wanted, most));
  plan.pictures = {rest.min, {rest.max.x, bottom}};
  plan.stage = {{rest.min.x, bottom + between}, rest.max};
  plan.folded = plan.stage.height() < least_stage * in.headline;
  if (plan.folded) {  // the pictures may as well have what a stage cannot use
    plan.pictures.max.y = std::round(rest.max.y - in.headline - between);
    plan.stage.min.y = plan.pictures.max.y + between;
  }
  return plan;
}

ExplorePlan plan_explore(const PlanInput& in, const ExploreShares& shares) {
  const float width = in.area.width(), height = in.area.height();
  const float least = 180 * in.scale;
  // They grow with the window only so far that the pictures keep their share.
  const float own_left = std::clamp(width * 0.183f, std::min(220 * in.scale, width * 0.24f), 300 * in.scale);
  const float own_right = std::clamp(width * 0.2f, std::min(236 * in.scale, width * 0.26f), 380 * in.scale);
  ExplorePlan plan;
  plan.left = shares.left > 0 ? static_cast<float>(shares.left) * width : own_left;
  plan.left = std::round(std::clamp(plan.left, std::min(least, width * 0.3f), width * 0.5f));
  plan.right = in.headline;
  if (shares.pixel_open) {
    plan.right = shares.right > 0 ? static_cast<float>(shares.right) * width : own_right;
    plan.right = std::round(std::clamp(plan.right, std::min(least, width * 0.3f), width * 0.5f));
  }
  plan.bottom = shares.bottom > 0 ? static_cast<float>(shares.bottom) * height : in.headline;
  plan.bottom = std::round(std::clamp(plan.bottom, in.headline, height * 0.7f));
  return plan;
}

}  // namespace ps::gui
