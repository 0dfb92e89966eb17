#pragma once
#include <deque>
#include <memory>
#include <string_view>

#include "student/scene_bytes.h"
#include "textbook/book_scene.h"

namespace ps {

/// A scene as scene_bytes() wrote it, with all that its parts point to.
struct ReadScene {
  ListingTask task;
  Scene scene;  ///< materials, textures, lights and canvas items; models and instances are below
  Settings settings;
  std::deque<Mesh> models;
  std::deque<Instance> instances;
  std::unique_ptr<BookScene> book;  ///< points into the others
};

/// Throws InputError where bytes are missing.
std::unique_ptr<ReadScene> read_scene(std::string_view bytes);

}  // namespace ps
