#pragma once
#include "scene/mesh.h"

namespace ps {

/// A sphere of radius 1 with `divisions` rings of as many quads each, built like the model of the book's shading demos
/// (CGFS ch. 13): rings at evenly spaced heights, so the quads at the poles are degenerate on one side. Vertex normals
/// are the positions. It has one material slot, left at index 0, and no name.
Mesh make_sphere_mesh(int divisions);

}  // namespace ps
