#pragma once
#include "frame/frame.h"
#include "options/settings.h"
#include "scene/scene.h"

namespace ps {

/// Decides what may draw a picture of the ray tracer, and says why no faster code may.
FastPath traced_fast_path(const Settings& settings, const SceneTraits& traits, Channel channels);

}  // namespace ps
