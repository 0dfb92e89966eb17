#include "record/event_keys.h"

#include <array>

#include "options/choice_key.h"

namespace ps {

std::string_view event_key(TestOutcome outcome) {
  switch (outcome) {
  case TestOutcome::accepted:
    return "accepted";
  case TestOutcome::missed:
    return "missed";
  case TestOutcome::before_range:
    return "before-range";
  case TestOutcome::beyond_range:
    return "beyond-range";
  case TestOutcome::farther:
    return "farther";
  case TestOutcome::back_side:
    return "back-side";
  case TestOutcome::tie_lost:
    return "tie-lost";
  case TestOutcome::parallel:
    return "parallel";
  case TestOutcome::degenerate:
    return "degenerate";
  case TestOutcome::excluded:
    return "excluded";
  }
  return "";
}

std::string_view event_key(RejectReason reason) {
  switch (reason) {
  case RejectReason::outside_view:
    return "outside-view";
  case RejectReason::clipped_near:
    return "clipped-near";
  case RejectReason::clipped_side:
    return "clipped-side";
  case RejectReason::clipped_far:
    return "clipped-far";
  case RejectReason::back_face:
    return "back-face";
  case RejectReason::zero_area:
    return "zero-area";
  case RejectReason::cut_out:
    return "cut-out";
  case RejectReason::not_covered:
    return "not-covered";
  case RejectReason::behind_camera:
    return "behind-camera";
  }
  return "";
}

std::string_view event_key(TextureUse use) {
  switch (use) {
  case TextureUse::surface:
    return "surface";
  case TextureUse::highlight:
    return "highlight";
  case TextureUse::ambient:
    return "ambient";
  case TextureUse::opacity:
    return "opacity";
  case TextureUse::reflection:
    return "reflection";
  }
  return "";
}

std::string_view event_key(RayKind kind) {
  switch (kind) {
  case RayKind::eye:
    return "eye";
  case RayKind::shadow:
    return "shadow";
  case RayKind::reflection:
    return "reflection";
  case RayKind::refraction:
    return "refraction";
  }
  return "";
}

std::string_view event_key(FragmentEvent::Depth depth) {
  switch (depth) {
  case FragmentEvent::Depth::passed:
    return "passed";
  case FragmentEvent::Depth::failed:
    return "failed";
  case FragmentEvent::Depth::off:
    return "off";
  }
  return "";
}

std::string_view event_key(FragmentEvent::Pass pass) {
  switch (pass) {
  case FragmentEvent::Pass::only:
    return "only";
  case FragmentEvent::Pass::depth_first:
    return "depth-first";
  case FragmentEvent::Pass::shading:
    return "shading";
  }
  return "";
}

std::string_view event_key(LightKind kind) { return light_kind_key(kind); }

std::string_view event_key(CanvasFill fill) { return choice_key<&Settings::canvas_fill>(fill); }

std::string_view event_key(Coverage strategy) { return choice_key<&Settings::coverage>(strategy); }

std::string_view cube_face_name(int face) {
  static constexpr std::array<std::string_view, 6> names{"+x", "-x", "+y", "-y", "+z", "-z"};
  return names.at(static_cast<std::size_t>(face));
}

}  // namespace ps
