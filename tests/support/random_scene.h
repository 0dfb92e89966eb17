#pragma once
#include "scene/scene.h"

namespace ps::test {

/// A scene made of numbers drawn from `seed`: spheres of all sizes with a huge one for the ground, a mesh with vertex
/// normals and texture coordinates in two placements, triangles that share edges, mirrors, tinted materials, lights of
/// every kind, and a camera that looks at it from somewhere.
Scene random_scene(unsigned seed);

}  // namespace ps::test
