#pragma once
#include "options/settings.h"
#include "scene/scene.h"

namespace ps::gui {

/// In words, the features that may show in the picture with these settings, and why each other one can be left out.
/// Known from the scene and the settings, before anything is measured. `letter`: of the side that has the settings.
void needs_known(const Settings& settings, const SceneTraits& traits, char letter);

}  // namespace ps::gui
