#pragma once
#include <optional>
#include <string>

#include "textbook/book_scene.h"

namespace ps {

/// The picture that the program of a student's own listing is asked for.
struct ListingTask {
  bool picture = true;          ///< the whole picture
  std::optional<Vec2i> traced;  ///< the values for this pixel (array position)
};

/// A scene and what to do with it, for the program of a student's own listing (student/runtime), which reads it from
/// its standard input. With what listings look at: models, materials, textures of colours and normals, lights, canvas
/// items.
std::string scene_bytes(const BookScene& scene, const ListingTask& task);

}  // namespace ps
