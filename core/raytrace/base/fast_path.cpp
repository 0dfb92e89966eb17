#include "raytrace/base/fast_path.h"

#include <string>

#include <fmt/format.h>

#include "accel/bvh.h"
#include "frame/fast_kernels.h"
#include "options/simd_choice.h"
#include "options/triangle_tests.h"
#include "raytrace/base/accelerators.h"
#include "raytrace/sampling/plan.h"

namespace ps {
namespace {

/// Beyond this many spheres the tree of boxes pays, or, without one, packets would test too much in vain.
constexpr std::size_t most_packet_spheres = bvh_no_tree;

bool fading_lights(const Settings& s, const SceneTraits& t) { return t.attenuated && s.attenuation; }

/// Why packets of rays against spheres cannot draw it; empty if they can.
std::string_view no_sphere_packets(const Settings& s, const SceneTraits& t, Channel channels) {
  if (t.triangles || t.solids || t.csg) return "packets of rays need a scene of spheres only";
  if (t.sphere_count > most_packet_spheres) return "packets of rays need a scene of at most 8 spheres";
  const bool one_ray = sampling_plan(s).mode == SamplingMode::one;  // then packets store shadows, too
  if (!only_fast_channels(one_ray ? without(channels, Channel::shadow) : channels))
    return "only scalar code stores what this view shows";
  if (s.projection != Projection::perspective) return "packets need projection = perspective";
  if (s.sphere_test != SphereTest::robust) return "packets need sphere-test = robust";
  if (s.self_hit != SelfHit::offset) return "packets need self-hit = offset";
  if (s.highlight != Highlight::phong) return "packets need highlight = phong";
  if (s.illumination != Illumination::book) return "packets need illumination = book";
  if (fading_lights(s, t)) return "packets need attenuation = off";
  if (!s.cache_constants) return "packets need cache-constants = on";
  if (s.shadow_cache) return "packets need shadow-cache = off";
  if (s.accelerator != Accelerator::bvh && s.accelerator != Accelerator::none)
    return "packets need accelerator = bvh or none";
  if (t.textures || t.normal_maps) return "packets do not support textures";
  if (t.tinted) return "packets need one colour per surface";
  if (t.odd_highlights) return "packets need exponents above 0";
  if (t.any_transparency) return "packets do not support transparency";
  return "";
}

/// Names the tests that have SIMD kernels.
std::string_view wide_tests_reason() {
  static const std::string reason = [] {
    std::string keys;
    for (const TriangleTestRow& row : triangle_test_rows)
      if (row.simd) keys += fmt::format("{}{}", keys.empty() ? "" : " or ", row.key);
    return "SIMD searches need triangle-test = " + keys;
  }();
  return reason;
}

/// Why SIMD cannot search the triangles; empty if it can.
std::string_view no_wide_triangles(const Settings& s, const SceneTraits& t, Channel channels) {
  if (!t.triangles) return "SIMD searches need a scene of triangles only";
  if (has(channels, Channel::tests)) return "the view shows the tests of the scalar search";
  if (!s.cache_constants) return "SIMD searches need cache-constants = on";
  const bool searched =
      uses_bvh<float>(s) || s.accelerator == Accelerator::octree || s.accelerator == Accelerator::none;
  if (!searched && s.accelerator == Accelerator::embree) return "Embree's kernels search, scalar code shades";
  if (!searched) return "SIMD searches need accelerator = bvh, octree or none";
  if (s.slab_test != SlabTest::robust) return "SIMD searches need slab-test = robust";
  if (!row_of(s.triangle_test).simd) return wide_tests_reason();
  if (t.one_sided) return "SIMD searches do not support one-sided triangles";
  if (t.any_transparency) return "SIMD searches do not support transparency";
  return "";
}

/// Which hits SIMD shades besides, and why not more.
FastPath shaded_hits(const Settings& s, const SceneTraits& t, Channel channels) {
  const auto single = [](std::string_view reason) {
    return FastPath{Machinery::wide_triangles, SurfaceShading::single, reason};
  };
  const auto mixed = [](std::string_view reason) {
    return FastPath{Machinery::wide_triangles, SurfaceShading::mixed, reason};
  };
  const SamplingMode mode = sampling_plan(s).mode;
  if (mode == SamplingMode::many) return single("SIMD shading needs one ray per pixel");
  if (mode == SamplingMode::subsampling) return single("SIMD shading needs subsampling = 1");
  if (!only_fast_channels(channels)) return single("only scalar shading stores what this view shows");
  if (s.illumination != Illumination::book) return single("SIMD shading needs illumination = book");
  if (fading_lights(s, t)) return single("SIMD shading needs attenuation = off");
  if (s.shadow_cache) return single("SIMD shading needs shadow-cache = off");
  const std::optional<Simd> target = widest_simd(s.simd);
  if (!target || *target == Simd::sse4) return single("SIMD shading of hits needs AVX2");
  if (mode == SamplingMode::adaptive) return mixed("further samples of a pixel are shaded one after the other");
  if (t.spheres || t.solids || t.csg) return mixed("SIMD shading needs hits on triangles");
  if (t.textures || t.normal_maps || t.height_maps) return mixed("textured surfaces are shaded one hit at a time");
  if (t.tinted || t.odd_highlights) return mixed("surfaces of several colours are shaded one hit at a time");
  if (s.reflection_depth > 0 && t.reflective) return mixed("reflective surfaces are shaded one hit at a time");
  return {Machinery::wide_triangles, SurfaceShading::lanes, ""};
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
