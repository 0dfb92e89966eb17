#pragma once
#include "frame/frame.h"
#include "frame/machinery.h"
#include "options/settings.h"
#include "scene/scene.h"

namespace ps {

/// The code path that draws a whole picture with these settings, and why not a faster one: the one place that decides.
/// Kernels ask it, and never draw faster than it says. (A region, or a texture too large for the SIMD kernels, may make
/// them draw slower: Frame::path says what drew a picture.)
FastPath fast_path(const Settings& settings, const SceneTraits& traits, Channel channels);

}  // namespace ps
