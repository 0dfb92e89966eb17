#pragma once
#include <functional>

#include "frame/view.h"
#include "raster/shadow/shadow_map.h"

namespace ps::raster {

/// Draws what a light sees: the depth channel of a picture without light, of the scene's casters alone.
using DrawDepth = std::function<Image<float>(const Scene& casters, const View& view, const Settings& settings)>;

/// The maps of all lights, drawn by any renderer. shadow_maps() draws them with the rasterizer and keeps them.
ShadowMaps draw_shadow_maps(const Scene& scene, const Settings& settings, const DrawDepth& draw_depth);

/// What the maps depend on.
Key shadow_maps_key(std::string_view product, const Scene& scene, const Settings& settings);

}  // namespace ps::raster
