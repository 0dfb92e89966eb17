#pragma once
#include <string_view>

#include "frame/frame.h"
#include "frame/prepared.h"
#include "options/settings.h"
#include "scene/scene.h"

namespace ps {

/// Channels that SIMD kernels store, too: what they know of a pixel before it is shaded.
inline constexpr Channel fast_channels = Channel::depth | Channel::ids;
constexpr bool only_fast_channels(Channel channels) { return (channels | fast_channels) == fast_channels; }

/// Why no SIMD kernel runs at all with these settings on this processor; empty if some can.
std::string_view no_simd_reason(const Settings& settings);

/// scene_traits(), found once for each revision of the scene.
SceneTraits prepared_traits(const Scene& scene, Prepared& prepared);

}  // namespace ps
