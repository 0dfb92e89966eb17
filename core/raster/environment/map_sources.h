#pragma once
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace ps::raster {

/// The objects that an environment map shows.
struct MapSources {
  std::vector<std::pair<std::size_t, Object>> objects;  ///< with their indices in the scene
  std::vector<std::shared_ptr<const Mesh>> meshes;
  bool operator==(const MapSources&) const = default;
};

/// Numbers for such sources: equal ones have equal numbers, as equal revisions of a Part mean equal content. A scene's
/// geometry gets a new revision when any object moves; these stay the same when an object moves that no map shows. Kept
/// in Prepared; safe to use from several threads.
class MapSourceNumbers {
 public:
  MapSourceNumbers();
  std::uint64_t number_of(MapSources sources) const;
  std::size_t heap_bytes() const;

 private:
  struct Known;
  std::shared_ptr<Known> known_;
};

}  // namespace ps::raster
