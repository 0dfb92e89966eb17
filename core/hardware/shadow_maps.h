#pragma once
#include <memory>
#include <vector>

#include "frame/prepared.h"
#include "hardware/picture_plan.h"
#include "math/vec.h"
#include "raster/shadow/shadow_map.h"

namespace ps::hardware {

/// The shadow maps that the plan asks for, drawn by this renderer; cached in `prepared`. Null where it asks for none.
std::shared_ptr<const raster::ShadowMaps> draw_maps(const PicturePlan& plan, Prepared& prepared,
                                                    WorkerPriority priority, Progress& progress);

/// Shadow maps in the memory of the graphics driver: their faces as layers of one texture.
class MapStore {
 public:
  MapStore() = default;
  ~MapStore();
  MapStore(const MapStore&) = delete;
  MapStore& operator=(const MapStore&) = delete;

  /// Binds them to a texture unit and a uniform block, uploaded if they are not there yet. Throws InputError where they
  /// have more faces than the driver has layers.
  void bind(const std::shared_ptr<const raster::ShadowMaps>& maps, int unit, unsigned block);

 private:
  void upload(const raster::ShadowMaps& maps);

  std::weak_ptr<const raster::ShadowMaps> held_;
  unsigned texture_ = 0, block_ = 0;
};

}  // namespace ps::hardware
