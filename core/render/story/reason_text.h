#pragma once
#include <array>
#include <string>
#include <string_view>

#include "record/events.h"

namespace ps {

/// Enumerators of events in words, for people; record/event_keys.h has their keys for files.
std::string_view outcome_text(TestOutcome outcome);
std::string_view reject_reason_text(RejectReason reason);

inline constexpr std::array all_reject_reasons{
    RejectReason::outside_view, RejectReason::clipped_near,  RejectReason::clipped_side,
    RejectReason::clipped_far,  RejectReason::behind_camera, RejectReason::zero_area,
    RejectReason::back_face,    RejectReason::cut_out,       RejectReason::not_covered};

/// "1 back face culled", "2 triangles nearer than the near plane"
std::string reject_count_text(RejectReason reason, std::size_t count);

/// The fault of a fragment that clipping should have prevented (CGFS ch. 9 and 11): "two of its vertices lie
/// behind the camera"; a perspective projection turns those upside down. Empty if all lie before it.
std::string behind_camera_text(const FragmentEvent& fragment);

/// ", 0.4 against 0.5 stored": what a failed depth test compared; empty where the renderer does not report it.
std::string depth_against_text(const FragmentEvent& fragment);

}  // namespace ps
