#include "raster/base/fast_path.h"

#include "frame/fast_kernels.h"
#include "raster/base/coverage_choice.h"
#include "raster/setup/draw_stage.h"

namespace ps {
namespace {

using namespace raster;

bool maps_shadows(const Settings& s, const SceneTraits& t) {
  if (!s.lighting || !t.casting_lights) return false;
  if (s.shadows == Shadows::map) return true;
  const bool stencil = s.shadows == Shadows::stencil_depth_fail || s.shadows == Shadows::stencil_depth_pass;
  return stencil && s.visibility == Visibility::depth_buffer;
}

/// Why fragments come one after the other; empty if they come in batches.
std::string_view no_batches(const Settings& s, const SceneTraits& t, Channel channels) {
  if (s.draw != Draw::filled) return "SIMD draws filled triangles only";
  if (s.projection != Projection::perspective) return "SIMD needs projection = perspective";
  if (s.interpolation != Interpolation::perspective) return "SIMD needs interpolation = perspective";
  if (!only_fast_channels(channels)) return "only scalar code stores what this view shows";
  if (s.multisampling > 1) return "SIMD needs multisampling = 1";
  if (!CoverageChoice{s.coverage, s.edge_arithmetic}.is_common())
    return "SIMD needs coverage = edge-function in 64-bit integers";
  if (s.depth_format != DepthFormat::plain) return "SIMD needs depth-format = plain";
  if (s.visibility == Visibility::depth_buffer && s.depth_value == DepthValue::ray_plane)
    return "SIMD interpolates depth: it needs another depth-value than ray-plane";
  if (draw_steps(s, 1).front().stage != DrawStage::whole)
    return "SIMD needs one pass: no early depth, deferred shading or light passes";
  if (s.illumination != Illumination::book) return "SIMD needs illumination = book";
  if (t.attenuated && s.attenuation) return "SIMD needs attenuation = off";
  if (maps_shadows(s, t)) return "SIMD does not support shadow maps or stencil shadows";
  if (s.environment != Environment::none && t.reflective) return "SIMD does not support environment maps";
  if (s.textures && t.opacity_maps) return "SIMD cuts nothing out by opacity maps";
  if (s.textures && t.reflection_maps && s.reflection_depth > 0) return "SIMD does not support reflection maps";
  if (s.anisotropy > 1) return "SIMD needs anisotropy = 1";
  return "";
}

/// Why some surface's fragments are shaded one after the other; empty if none are.
std::string_view no_plain_surfaces(const Settings& s, const SceneTraits& t) {
  if (t.tinted || t.odd_highlights) return "surfaces of several colours are shaded one fragment at a time";
  if (s.parallax != Parallax::off && t.height_maps) return "reliefs are shaded one fragment at a time";
  if (s.normal_mapping && t.normal_maps && s.lighting && s.shading == Shading::phong && t.casting_lights)
    return "normal maps are shaded one fragment at a time";
  return "";
}

/// Why triangles are drawn one after the other; empty if whole tiles are drawn at once.
std::string_view no_whole_frame(const Settings& s, const SceneTraits& t) {
  if (s.visibility != Visibility::depth_buffer) return "whole tiles need visibility = depth-buffer";
  if (s.depth_value != DepthValue::inverse_z) return "whole tiles need depth-value = inverse-z";
  if (!s.camera_relative) return "whole tiles need camera-relative = on";
  if (s.subpixel_bits > fast_subpixel_bits) return "whole tiles need at most 8 sub-pixel bits";
  if (t.canvas_items) return "the tiled SIMD path does not draw canvas items";
  if (s.lighting && s.shading != Shading::phong) return "whole tiles need shading = phong";
  return "";
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
