#pragma once
#include <functional>

#include "frame/view.h"
#include "raster/environment/environment_map.h"

namespace ps::raster {

/// Draws the surroundings of a point: the colours of a picture of these objects.
using DrawColours = std::function<Image<Vec3f>(const Scene& shown, const View& view, const Settings& settings)>;

/// The maps of all mirrors, drawn by the renderer of the settings and cached in `prepared`. environment_maps() draws
/// them with the rasterizer. Throws InputError where the computer cannot spare what `copies` of them take.
std::shared_ptr<const EnvironmentMaps> draw_environment_maps(const Scene& scene, const Settings& settings,
                                                             Prepared& prepared, int copies, const DrawColours& draw);

}  // namespace ps::raster
