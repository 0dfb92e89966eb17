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

const auto& table() {
  static const std::array experiments{
      ground_sphere_acne,
      reflection_self_hit,
      epsilon_too_large,
      epsilon_unit,
      ray_sphere_cancellation,
      stable_q_alone,
      world_offset_sphere_acne,
      constant_normal_bump,
      triangle_edge_cracks,
      cracks_in_an_image,
      mt_tolerance,
      absolute_det_epsilon,
      fma_contraction,
      plucker_vertices,
      nan_in_moller_trumbore,
      degenerate_zero_radius,
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
      inclusive_scanlines,
      interpolate_drift,
      inverse_depth,
      affine_texture,
      depth_bits_z_fighting,
      near_plane,
      sixteen_bit_linear_z,
      painters_cycle,
      near_plane_clipping,
      shadow_map_acne,
      pcf_one_tap_bias,
      peter_panning,
      z_pass_in_volume,
      near_plane_cuts_volume,
      z_fail_caps,
      stencil_bits_wrap,
      gouraud_highlight,
      unnormalised_interpolated_normals,
      normal_under_scale,
      shadow_terminator,
      silhouette_tessellation,
      far_from_origin,
      lookat_up_forward,
      supersampling_rate,
      grid_moire,
      adaptive_sampling_misses,
      sub_pixel_disc_missed,
      subsampling_bars,
      mipmap_lod,
      texture_too_large,
      srgb_averaging,
      sample_accumulation,
      recursion_depth,
      refraction_total_internal,
      acos_of_unit_dot,
      nan_in_a_picture,
      build_flags,
      precision,
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
  throw InputError(fmt::format("unknown experiment '{}'; did you mean '{}'?", key, nearest_word(key, known)));
}

std::string stability_csv(std::span<const StabilityRow> rows) {
  std::string text = "knob,series,naive,robust,unit\n";
  for (const StabilityRow& row : rows)
    text += fmt::format("{},\"{}\",{},{},\"{}\"\n", row.knob, row.series, number_field(row.naive),
                        number_field(row.robust), row.unit);
  return text;
}

}  // namespace ps
