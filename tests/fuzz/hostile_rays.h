#pragma once
#include <cstdint>
#include <functional>
#include <string_view>

#include "options/settings.h"
#include "scene/scene.h"

namespace ps::fuzz {

/// Where hostile numbers come from: a random generator, or the bytes of a fuzzer. Any value of 32 bits each time.
using Draws = std::function<std::uint32_t()>;

/// So many triangles, and spheres and a box, of sizes from 1e-30 to 1e6.
Scene hostile_scene(int triangles, const Draws& draw);

/// Sends `rays` rays of NaN, infinities, denormals, zeros and huge numbers to every search that there is for the scene
/// under these settings. Each ends within its stack, and has no hit along a ray that is not one; else an assertion
/// fails.
void search_scene(const Scene& scene, const Settings& settings, int rays, const Draws& draw);

/// The same for the kernels of the searches themselves: rays that the scene's searches keep away from them, in trees
/// over `boxes` boxes, and as many balls and triangles, of such numbers.
void search_trees(int boxes, int rays, const Draws& draw);

/// A small scene and small trees, and what is sent to them, all as the bytes say.
void search_as_bytes_say(std::string_view bytes);

}  // namespace ps::fuzz
