#pragma once
#include <array>
#include <string>
#include <string_view>

#include "record/events.h"

namespace ps {

/// Enumerators of events in words (for people) and as keys (for files, in kebab-case).
std::string_view outcome_text(TestOutcome outcome);
std::string_view outcome_key(TestOutcome outcome);
std::string_view reject_reason_text(RejectReason reason);
std::string_view reject_reason_key(RejectReason reason);
std::string_view ray_kind_key(RayKind kind);
/// "surface", "highlight"
std::string_view texture_use_key(TextureUse use);
std::string_view coverage_key(Coverage strategy);
std::string_view depth_verdict_key(FragmentEvent::Depth depth);

inline constexpr std::array all_reject_reasons{
    RejectReason::outside_view, RejectReason::clipped_near,  RejectReason::clipped_side,
    RejectReason::clipped_far,  RejectReason::behind_camera, RejectReason::zero_area,
    RejectReason::back_face,    RejectReason::cut_out,       RejectReason::not_covered};

/// "1 back face culled", "2 triangles nearer than the near plane"
std::string reject_count_text(RejectReason reason, std::size_t count);

/// What is wrong with a fragment that clipping should have prevented (CGFS ch. 9 and 11): "two of its vertices lie
/// behind the camera"; a perspective projection turns those upside down. Empty if all lie before it.
std::string behind_camera_text(const FragmentEvent& fragment);

}  // namespace ps
