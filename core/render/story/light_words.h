#pragma once
#include <string>

#include "record/events.h"
#include "scene/scene.h"

namespace ps {

/// Whether an intensity (linear, 1 = white) is too small to change any sum that is shown. Far from a highlight a
/// high power of a cosine is a number like 1e-98; whatever is below 1e-13 leaves each float sum from 2e-6 on, a
/// two-thousandth of a display level, as it is.
bool adds_nothing(double intensity);

/// How much of a light is described beside its effect.
enum class LightWords {
  brief,  ///< for a row among many: "surface faces away"
  whole   ///< for a sentence by itself: "adds nothing: the surface faces away from it"
};

/// The effect of a light at a point of a surface, without its name: "0.2 everywhere", "diffuse 0.47, specular 0.32",
/// "blocked by sphere 3", "in shadow", "adds no light". Terms of 0 are described without their number.
std::string light_effect_text(const Scene& scene, const LightEvent& light, LightWords words);

/// Light as one number where its channels are equal, else as three.
std::string light_text(const Vec3d& light);

}  // namespace ps
