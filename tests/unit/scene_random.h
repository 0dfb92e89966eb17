#pragma once
#include <random>

#include "scene/scene.h"

namespace ps::test {

/// A scene with some of everything that a scene file can say, in the form that reading one gives.
Scene scene_with_everything(std::mt19937_64& random);

/// Equal in everything but revisions, file names and the scene's own name.
void expect_equal_scenes(const Scene& a, const Scene& b);

}  // namespace ps::test
