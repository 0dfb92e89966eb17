#pragma once
#include <vector>

#include "options/settings.h"

namespace ps::raster {

/// What one walk over the triangles does (CGPP 15.8.3). Pictures need one walk, or first one that finds out what is
/// visible and then others that shade only that.
enum class DrawStage {
  whole,          ///< depth test, shading, write
  depth_only,     ///< early depth: fills the depth buffer
  keep_winners,   ///< deferred shading: also keeps which triangle each pixel shows, and where on it
  shade_visible,  ///< shades the fragments whose depth is the buffer's
  one_light       ///< the same with a single light, added to what the lights before it gave
};

struct DrawStep {
  DrawStage stage = DrawStage::whole;
  int light = 0;  ///< of stage one_light
  bool is_first() const { return stage <= DrawStage::keep_winners; }
};

inline bool keeps_stencil(const Settings& settings) {
  return (settings.shadows == Shadows::stencil_depth_fail || settings.shadows == Shadows::stencil_depth_pass) &&
         settings.visibility == Visibility::depth_buffer;
}
/// Are translucent surfaces blended with what is behind them? Not where a stencil holds the shadows of one surface
/// only.
inline bool blends(const Settings& settings) {
  return settings.blending != Blending::off && fills(settings.draw) && !keeps_stencil(settings);
}
/// Are triangles, or those that are translucent, drawn from back to front?
inline bool sorts_triangles(const Settings& settings) {
  return settings.visibility == Visibility::painter || (blends(settings) && settings.blending == Blending::sorted);
}
inline bool has_passes(const Settings& settings) {
  return settings.draw == Draw::filled && settings.visibility == Visibility::depth_buffer &&
         settings.multisampling < 2 && !blends(settings);
}
inline bool lights_one_by_one(const Settings& settings) {
  return has_passes(settings) && settings.light_passes == LightPasses::many && settings.lighting &&
         settings.shading == Shading::phong;
}
inline bool defers_shading(const Settings& settings) {
  return has_passes(settings) && settings.deferred_shading && !lights_one_by_one(settings);
}

/// The walks over the triangles that the settings ask for, in order. Deferred shading needs no second one.
inline std::vector<DrawStep> draw_steps(const Settings& settings, std::size_t lights) {
  if (lights_one_by_one(settings) && lights > 0) {
    std::vector<DrawStep> steps{{DrawStage::depth_only, 0}};
    for (std::size_t i = 0; i < lights; ++i) steps.push_back({DrawStage::one_light, static_cast<int>(i)});
    return steps;
  }
  if (defers_shading(settings)) return {{DrawStage::keep_winners, 0}};
  if (has_passes(settings) && settings.early_depth) return {{DrawStage::depth_only, 0}, {DrawStage::shade_visible, 0}};
  return {{DrawStage::whole, 0}};
}

}  // namespace ps::raster
