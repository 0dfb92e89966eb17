#pragma once
#include "record/story.h"
#include "scene/scene.h"

namespace ps::test {

/// Three spheres of the book (red, blue, green) with its three lights, for names and materials.
Scene book_spheres();

/// A story written by hand: the eye ray meets the red sphere, which mirrors the blue one (1 bounce); light 1 is blocked
/// at the first hit. Numbers are round, not those of a real ray.
PixelStory mirrored_story();

}  // namespace ps::test
