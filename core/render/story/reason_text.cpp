#include "render/story/reason_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "record/value_text.h"

namespace ps {

std::string_view outcome_text(TestOutcome outcome) {
  switch (outcome) {
  case TestOutcome::accepted:
    return "hit, the nearest so far";
  case TestOutcome::missed:
    return "missed";
  case TestOutcome::before_range:
    return "intersection below t min";
  case TestOutcome::beyond_range:
    return "intersection above t max";
  case TestOutcome::farther:
    return "hit, but farther than the nearest so far";
  case TestOutcome::tie_lost:
    return "hit at the same t as a primitive with a lower index";
  case TestOutcome::back_side:
    return "back side of a one-sided surface";
  case TestOutcome::parallel:
    return "missed: ray parallel to its plane";
  case TestOutcome::degenerate:
    return "skipped: zero area";
  case TestOutcome::excluded:
    return "not tested: the ray starts on it";
  }
  return "";
}

std::string_view reject_reason_text(RejectReason reason) {
  switch (reason) {
  case RejectReason::outside_view:
    return "the whole object lies outside the view volume";
  case RejectReason::clipped_near:
    return "clipped: nearer than the near plane";
  case RejectReason::clipped_side:
    return "clipped: outside a side plane of the view volume";
  case RejectReason::clipped_far:
    return "clipped: beyond the far plane";
  case RejectReason::back_face:
    return "culled: its back faces the camera";
  case RejectReason::zero_area:
    return "dropped: zero area";
  case RejectReason::cut_out:
    return "cut out: its opacity map is below 1/2 here";
  case RejectReason::not_covered:
    return "close to the pixel, but does not cover it";
  case RejectReason::behind_camera:
    return "cannot be projected: a vertex lies behind the camera and clipping is off";
  }
  return "";
}

std::string reject_count_text(RejectReason reason, std::size_t count) {
  const bool one = count == 1;
  const std::string_view triangles = one ? "triangle" : "triangles";
  switch (reason) {
  case RejectReason::outside_view:
    return fmt::format("{} {} outside the view volume", count, triangles);
  case RejectReason::clipped_near:
    return fmt::format("{} {} nearer than the near plane", count, triangles);
  case RejectReason::clipped_side:
    return fmt::format("{} {} outside a side plane", count, triangles);
  case RejectReason::clipped_far:
    return fmt::format("{} {} beyond the far plane", count, triangles);
  case RejectReason::back_face:
    return fmt::format("{} back {} culled", count, one ? "face" : "faces");
  case RejectReason::zero_area:
    return fmt::format("{} {} with zero area", count, triangles);
  case RejectReason::cut_out:
    return fmt::format("{} {} cut out by an opacity map", count, triangles);
  case RejectReason::not_covered:
    return fmt::format("{} {} close to the pixel {} not cover it", count, triangles, one ? "does" : "do");
  case RejectReason::behind_camera:
    return fmt::format("{} {} behind the camera", count, triangles);
  }
  return {};
}

std::string behind_camera_text(const FragmentEvent& fragment) {
  if (fragment.id.object < 0) return {};  // drawn on the canvas, which has no depth
  const auto behind =
      std::count_if(fragment.corner_depth.begin(), fragment.corner_depth.end(), [](double z) { return !(z > 0); });
  if (behind == 0) return {};
  if (behind == 3) return "all its vertices lie behind the camera";
  return behind == 1 ? "one of its vertices lies behind the camera" : "two of its vertices lie behind the camera";
}

std::string depth_against_text(const FragmentEvent& fragment) {
  if (!fragment.depth_stored || !fragment.depth_new) return {};
  return fmt::format(", {} stored", against_text(*fragment.depth_new, *fragment.depth_stored));
}

}  // namespace ps
