#pragma once
#include "raster/setup/tessellate.h"
#include "scene/solid.h"

namespace ps::raster {

/// An upper bound of how much the matrix stretches any vector; exact for a rotation with one scale.
double largest_stretch(const Mat3d& matrix);

/// The view as a body sees it in its own space, which `place` takes to the world: triangles that are fine enough there
/// are so in the world, wherever the map stretches most.
TessellationView seen_from_within(const PartPlace& place, const TessellationView& view);

/// Takes a body's mesh from its own space to the world. Normals stay normals, and triangles keep their fronts also
/// where the map mirrors.
void place_mesh(const PartPlace& place, Mesh& mesh);

}  // namespace ps::raster
