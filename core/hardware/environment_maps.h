#pragma once
#include <memory>
#include <vector>

#include "frame/prepared.h"
#include "hardware/picture_plan.h"
#include "raster/environment/environment_map.h"

namespace ps::hardware {

/// The environment maps that the plan asks for, drawn by this renderer; cached in `prepared`. Null where it asks for
/// none.
std::shared_ptr<const raster::EnvironmentMaps> draw_environment(const PicturePlan& plan, Prepared& prepared,
                                                                WorkerPriority priority, Progress& progress);

/// Environment maps in the memory of the graphics driver: the faces of all of them as layers of one texture.
class EnvironmentStore {
 public:
  EnvironmentStore() = default;
  ~EnvironmentStore();
  EnvironmentStore(const EnvironmentStore&) = delete;
  EnvironmentStore& operator=(const EnvironmentStore&) = delete;

  /// Binds them to a texture unit, uploaded if they are not there yet. Throws InputError where they have more faces
  /// than the driver has layers.
  void bind(const std::shared_ptr<const raster::EnvironmentMaps>& maps, int unit);
  /// Number of the first layer of an object's map, of those that were bound last; -1 where it has none.
  int first_layer(int object) const { return layers_[static_cast<std::size_t>(object)]; }

 private:
  void upload(const raster::EnvironmentMaps& maps);

  std::weak_ptr<const raster::EnvironmentMaps> held_;
  std::vector<int> layers_;  ///< by object
  unsigned texture_ = 0;
};

}  // namespace ps::hardware
