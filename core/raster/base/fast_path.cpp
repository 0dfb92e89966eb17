#include "raster/base/fast_path.h"

#include "frame/fast_kernels.h"
#include "options/fast_limits.h"

namespace ps {
namespace {

using namespace raster;

/// Why fragments come one after the other; empty if they come in batches.
std::string_view no_batches(const Settings& s, const SceneTraits& t, Channel channels) {
  constexpr int after_interpolation = 40;
  std::string_view own;
  if (!only_fast_channels(channels)) own = "only scalar code stores what this view shows";
  if (t.term_colours && s.lighting) own = "SIMD needs one colour per light";
  return fast_limit(FastCode::fragment_batches, s, t, after_interpolation, own);
}

/// Why some surface's fragments are shaded one after the other; empty if none are.
std::string_view no_plain_surfaces(const Settings& s, const SceneTraits& t) {
  if (t.tinted || t.odd_highlights) return "surfaces of several colours are shaded one fragment at a time";
  return fast_limit(FastCode::every_fragment, s, t);
}

/// Why triangles are drawn one after the other; empty if whole tiles are drawn at once.
std::string_view no_whole_frame(const Settings& s, const SceneTraits& t) {
  constexpr int before_shading = 50;
  return fast_limit(FastCode::whole_tiles, s, t, before_shading,
                    t.canvas_items ? "the tiled SIMD path does not draw canvas items" : "");
}

}  // namespace

// The same surfaces as in no_plain_surfaces(), one by one.
bool raster::shades_in_lanes(const Surface<float>& surface) {
  if (surface.layout.relief || surface.layout.tangents != AttributeLayout::absent) return false;
  const ShadingMaterial<float>& material = surface.material;
  return !material.ambient_colour && !material.specular_colour && (!material.specular || *material.specular > 0);
}

FastPath raster::within_limits(const FastPath& allowed, const PictureLimits& limits) {
  const auto batches = [](std::string_view reason) {
    return FastPath{Machinery::fragment_batches, SurfaceShading::lanes, reason};
  };
  if (allowed.machinery != Machinery::whole_frame) return allowed;
  if (limits.part_only) return batches("the tiled SIMD path needs the whole picture");
  if (limits.large_textures) return batches("a texture is too large for the SIMD kernels");
  return allowed;
}

FastPath rasterized_fast_path(const Settings& settings, const SceneTraits& traits, Channel channels) {
  std::string_view reason = no_simd_reason(settings);
  if (reason.empty()) reason = no_batches(settings, traits, channels);
  if (!reason.empty()) return {Machinery::clear, SurfaceShading::single, reason};
  if (reason = no_plain_surfaces(settings, traits); !reason.empty())
    return {Machinery::fragment_batches, SurfaceShading::mixed, reason};
  if (reason = no_whole_frame(settings, traits); !reason.empty())
    return {Machinery::fragment_batches, SurfaceShading::lanes, reason};
  return {Machinery::whole_frame, SurfaceShading::lanes, ""};
}

}  // namespace ps
