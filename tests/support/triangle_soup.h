#pragma once
#include <random>

#include "scene/scene.h"

namespace ps::test {

/// Triangles of every kind that fast paths treat apart: smaller than a pixel, small, large, cut by the planes and by
/// the guard band, flat, behind the camera, one before the other; with and without normals; untextured, with texels of
/// any number and with those of a picture file. Two meshes of 900 and 3,000, and a strip whose neighbours share edges.
Scene triangle_soup(std::mt19937& random);

}  // namespace ps::test
