#pragma once
#include "image/image.h"
#include "options/settings.h"
#include "scene/scene.h"

namespace ps::test {

/// The picture of the scene from its camera, as shown.
Image<Rgb8> levels_of(const Scene& scene, const Settings& settings, int width, int height);

/// Pixels that differ by more than two levels. The pictures have one size.
int differing(const Image<Rgb8>& a, const Image<Rgb8>& b);

}  // namespace ps::test
