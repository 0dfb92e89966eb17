#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/check.h"
#include "base/spelling.h"
#include "study/stability/experiments.h"

namespace ps {
namespace {

using namespace stability;

StabilityExperiment reproduction(StabilityExperiment experiment) {
  experiment.set_up = SetUp::reproduction;
  return experiment;
}

const auto& table() {
  static const std::array experiments{
      reproduction(ground_sphere_acne),
      reproduction(reflection_self_hit),
      epsilon_too_large,
      reproduction(epsilon_unit),
      reproduction(ray_sphere_cancellation),
      reproduction(stable_q_alone),
      world_offset_sphere_acne,
      constant_normal_bump,
      reproduction(triangle_edge_cracks),
      cracks_in_an_image,
      reproduction(mt_tolerance),
      absolute_det_epsilon,
      reproduction(fma_contraction),
      reproduction(plucker_vertices),
      reproduction(nan_in_moller_trumbore),
      reproduction(degenerate_zero_radius),
      slab_test_false_miss,
      bvh_holes,
      zero_inf_nan_slab,
      grid_octree_borders,
      nan_vertex,
      infinite_vertex,
      fill_rule_easy,
      fill_rule_adversarial,
      int32_edge_functions,
      stepped_edge_drift,
      sub_pixel_bits,
      ray_vs_raster_agreement,
      coverage_growth,
      inclusive_scanlines,
      reproduction(interpolate_drift),
      reproduction(inverse_depth),
      reproduction(affine_texture),
      reproduction(depth_bits_z_fighting),
      reproduction(near_plane),
      reproduction(sixteen_bit_linear_z),
      painters_cycle,
      near_plane_clipping,
      reproduction(shadow_map_acne),
      reproduction(pcf_one_tap_bias),
      peter_panning,
      z_pass_in_volume,
      near_plane_cuts_volume,
      z_fail_caps,
      stencil_bits_wrap,
      gouraud_highlight,
      reproduction(unnormalised_interpolated_normals),
      reproduction(normal_under_scale),
      shadow_terminator,
      reproduction(silhouette_tessellation),
      far_from_origin,
      reproduction(lookat_up_forward),
      reproduction(supersampling_rate),
      reproduction(grid_moire),
      adaptive_sampling_misses,
      reproduction(sub_pixel_disc_missed),
      reproduction(subsampling_bars),
      mipmap_lod,
      texture_too_large,
      reproduction(srgb_averaging),
      reproduction(sample_accumulation),
      reproduction(recursion_depth),
      reproduction(refraction_total_internal),
      acos_of_unit_dot,
      reproduction(nan_in_a_picture),
      reproduction(build_flags),
      reproduction(precision),
  };
  return experiments;
}

std::string number_field(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

}  // namespace

std::span<const StabilityExperiment> stability_experiments() { return table(); }

const StabilityExperiment& find_stability_experiment(std::string_view key) {
  const auto found = std::find_if(table().begin(), table().end(), [&](const auto& row) { return row.key == key; });
  if (found != table().end()) return *found;
  std::vector<std::string_view> known;
  for (const StabilityExperiment& row : table()) known.push_back(row.key);
  throw InputError(fmt::format("unknown experiment '{}'{}", key,
                               did_you_mean(key, known, "; 'pixelscope-cli stability --help' lists them")));
}

std::string_view set_up_text(SetUp set_up) {
  switch (set_up) {
  case SetUp::illustration:
    return "an illustration of our own";
  case SetUp::reproduction:
    return "reproduces another measurement";
  }
  return "";
}

std::string stability_csv(std::span<const StabilityRow> rows) {
  std::string text = "knob,series,naive,robust,unit\n";
  for (const StabilityRow& row : rows)
    text += fmt::format("{},\"{}\",{},{},\"{}\"\n", row.knob, row.series, number_field(row.naive),
                        number_field(row.robust), row.unit);
  return text;
}

}  // namespace ps
