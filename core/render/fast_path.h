#pragma once
#include "options/settings.h"
#include "render/frame.h"
#include "render/machinery.h"
#include "render/prepared.h"
#include "scene/scene.h"

namespace ps {

/// Which machinery draws a whole picture with these settings, and why it is nothing faster: the one place that decides.
/// Kernels ask it, and never draw faster than it says. (A region, or a texture too large for the SIMD kernels, may make
/// them draw slower: Frame::path says what drew a picture.)
FastPath fast_path(const Settings& settings, const SceneTraits& traits, Channel channels);

/// The same of each renderer.
FastPath traced_fast_path(const Settings& settings, const SceneTraits& traits, Channel channels);
FastPath rasterized_fast_path(const Settings& settings, const SceneTraits& traits, Channel channels);

/// Channels that SIMD kernels store, too: what they know of a pixel before it is shaded.
inline constexpr Channel fast_channels = Channel::depth | Channel::ids;
constexpr bool only_fast_channels(Channel channels) { return (channels | fast_channels) == fast_channels; }

/// Why no SIMD kernel runs at all with these settings on this processor; empty if some can.
std::string_view no_simd_reason(const Settings& settings);

/// scene_traits(), found once for each revision of the scene.
SceneTraits prepared_traits(const Scene& scene, Prepared& prepared);

}  // namespace ps
