#pragma once
#include <cstdint>
#include <vector>

#include "scene/mesh.h"
#include "textbook/book_scene.h"

namespace ps {

/// Some triangles of a model, with the vertices that they need and no others.
struct MeshPart {
  Mesh mesh;
  std::vector<std::uint32_t> numbers;  ///< of each of its triangles: index in the whole model
};

/// The triangles of an instance that a listing without clipping may draw at `pixel` (as the book counts), in their
/// order: those with that place within two pixels of the box around their vertices on the canvas, since listings drop
/// fractions of a pixel here and there. Triangles that reach behind the camera have no such box and are always among
/// them. Work: one pass over the model.
MeshPart part_near_pixel(const BookScene& scene, const BookInstance& instance, Vec2i pixel);

}  // namespace ps
