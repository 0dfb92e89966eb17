#pragma once
#include "options/settings.h"
#include "scene/scene.h"

namespace ps::gui {

/// A table of all features: with which option each may show in the picture, or why it cannot. Known from the scene and
/// the settings, before anything is measured. `letter`: of the side that has the settings.
void needs_known(const Settings& settings, const SceneTraits& traits, char letter);

}  // namespace ps::gui
