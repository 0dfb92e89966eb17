#include "raytrace/base/fast_path.h"

#include "accel/bvh.h"
#include "frame/fast_kernels.h"
#include "options/fast_limits.h"
#include "raytrace/sampling/plan.h"

namespace ps {
namespace {

/// Beyond this many spheres the tree of boxes pays, or, without one, packets would test too much in vain.
constexpr std::size_t most_packet_spheres = bvh_no_tree;

/// Why packets of rays against spheres cannot draw it; empty if they can.
std::string_view no_sphere_packets(const Settings& s, const SceneTraits& t, Channel channels) {
  if (t.triangles || t.solids || t.csg) return "packets of rays need a scene of spheres only";
  if (t.sphere_count > most_packet_spheres) return "packets of rays need a scene of at most 8 spheres";
  const bool one_ray = sampling_plan(s).mode == SamplingMode::one;  // then packets store shadows, too
  if (!only_fast_channels(one_ray ? without(channels, Channel::shadow) : channels))
    return "only scalar code stores what this view shows";
  if (const auto reason = fast_limit(FastCode::sphere_packets, s, t); !reason.empty()) return reason;
  if (t.textures || t.normal_maps) return "packets do not support textures";
  if (t.tinted) return "packets need one colour per surface";
  if (t.term_colours) return "packets need one colour per light";
  if (t.odd_highlights) return "packets need exponents above 0";
  if (t.any_transparency) return "packets do not support transparency";
  return "";
}

/// Why SIMD cannot search the triangles; empty if it can.
std::string_view no_wide_triangles(const Settings& s, const SceneTraits& t, Channel channels) {
  if (!t.triangles) return "SIMD searches need a scene of triangles only";
  if (has(channels, Channel::tests)) return "the view shows the tests of the scalar search";
  if (const auto reason = fast_limit(FastCode::triangle_search, s, t); !reason.empty()) return reason;
  if (t.any_transparency) return "SIMD searches do not support transparency";
  return "";
}

/// Which surfaces of the scene SIMD does not shade; empty if it shades all.
std::string_view no_plain_surfaces(const SceneTraits& t) {
  if (t.spheres || t.solids || t.csg) return "SIMD shading needs hits on triangles";
  if (t.textures || t.normal_maps || t.height_maps) return "textured surfaces are shaded one hit at a time";
  if (t.tinted || t.odd_highlights) return "surfaces of several colours are shaded one hit at a time";
  return "";
}

/// Which hits SIMD shades besides, and why not more.
FastPath shaded_hits(const Settings& s, const SceneTraits& t, Channel channels) {
  constexpr int after_sampling = 30, before_reflection = 20;
  std::string_view own;
  if (!only_fast_channels(channels)) own = "only scalar shading stores what this view shows";
  if (t.term_colours) own = "SIMD shading needs one colour per light";
  const std::string_view none = fast_limit(FastCode::hit_shading, s, t, after_sampling, own);
  if (!none.empty()) return {Machinery::wide_triangles, SurfaceShading::single, none};
  const std::string_view some = fast_limit(FastCode::every_hit, s, t, before_reflection, no_plain_surfaces(t));
  return {Machinery::wide_triangles, some.empty() ? SurfaceShading::lanes : SurfaceShading::mixed, some};
}

}  // namespace

FastPath traced_fast_path(const Settings& settings, const SceneTraits& traits, Channel all_channels) {
  const Channel channels = without(all_channels, Channel::samples);  // the picture keeps them, not its kernels
  const auto clear = [](std::string_view reason) { return FastPath{Machinery::clear, SurfaceShading::single, reason}; };
  if (const auto reason = no_simd_reason(settings); !reason.empty()) return clear(reason);
  const std::string_view no_packets = no_sphere_packets(settings, traits, channels);
  if (no_packets.empty()) return {Machinery::sphere_packets, SurfaceShading::lanes, ""};
  if (!traits.triangles) return clear(no_packets);
  const std::string_view no_search = no_wide_triangles(settings, traits, channels);
  if (!no_search.empty()) return clear(no_search);
  return shaded_hits(settings, traits, channels);
}

}  // namespace ps
