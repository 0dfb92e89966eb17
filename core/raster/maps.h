#pragma once
#include "raster/base/raster_inputs.h"
#include "raster/environment/environment_map.h"
#include "raster/shadow/shadow_map.h"
#include "raster/shadow/stencil.h"

namespace ps::raster {

/// Draws the scene from each light, with the rasterizer itself. Cached in `prepared` for as long as geometry, lights,
/// materials, size and tessellation stay what they are. Transparent objects cast no shadow, as for rays. Throws
/// InputError where the maps together, which are all read for every pixel, need more memory than there is.
std::shared_ptr<const ShadowMaps> shadow_maps(const Scene& scene, const Settings& settings, Prepared& prepared,
                                              WorkerPriority priority, Progress& progress);

/// With environment = cube-map each mirroring object has a map of its own, made at its centre, of all other objects
/// (without what those mirror themselves). With room-map all share one: that of the objects without reflections,
/// rendered from their centre, wherever the reflective objects are. Each is cached in `prepared` until something
/// changes that can be seen in it: with environment-objects = static a dynamic object that moves changes none but its
/// own, and a mirror that moves never changes that of the room.
std::shared_ptr<const EnvironmentMaps> environment_maps(const Scene& scene, const Settings& settings,
                                                        Prepared& prepared, WorkerPriority priority,
                                                        Progress& progress);

/// Makes the shadow maps, stencil buffers (for the pixels of `rect`) and environment maps that the settings ask for.
template <class Real>
void add_maps(RasterInputs<Real>& inputs, const Scene& scene, const View& view, const TileRect& rect,
              StencilNotes notes, Prepared& prepared, const ParallelOptions& parallel, Progress& progress);

/// Fills the channels that show maps and stencil buffers, and counts what those took.
template <class Real>
void store_map_pictures(const RasterInputs<Real>& inputs, Frame& frame);

}  // namespace ps::raster
