#include "study/unsafe_settings.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/check.h"
#include "frame/display_frame.h"
#include "image/difference.h"
#include "options/option.h"

namespace ps {
namespace {

/// When an option leaves the window of an experiment, and what brings it back.
struct Rule {
  std::string_view option, experiment;
  bool (*leaves)(const Settings&);
  std::string_view safe;     ///< "KEY=VALUE;KEY=VALUE"
  std::string_view probe{};  ///< set while it is measured, so that only what this option does is seen
};

bool guarded_by_epsilon(const Settings& s) { return s.self_hit == SelfHit::epsilon; }
bool fixed_map_bias(const Settings& s) {
  return s.shadow_slope_bias >= 0 && s.shadow_slope_bias < 0.5 * s.shadow_filter;
}

/// In the order of the option table's groups. Windows are those of the experiments (core/study/stability).
constexpr Rule rules[] = {
    {"clipping", "near-plane-clipping", [](const Settings& s) { return s.clipping == Clipping::none; },
     "clipping=full"},
    {"camera-relative", "far-from-origin", [](const Settings& s) { return !s.camera_relative; }, "camera-relative=on"},
    {"visibility", "painter-s-cycle", [](const Settings& s) { return s.visibility != Visibility::depth_buffer; },
     "visibility=depth-buffer"},
    {"depth-format", "depth-bits-z-fighting",
     [](const Settings& s) {
       return s.depth_format == DepthFormat::unorm || (s.depth_format == DepthFormat::unit_float && !s.depth_reversed);
     },
     "depth-format=plain"},
    {"depth-value", "z-vs-1-z", [](const Settings& s) { return s.depth_value == DepthValue::z; },
     "depth-value=inverse-z"},
    {"fill-rule", "fill-rule-easy", [](const Settings& s) { return s.fill_rule != FillRule::top_left; },
     "fill-rule=top-left"},
    {"edge-arithmetic", "fill-rule-adversarial",
     [](const Settings& s) {
       return s.edge_arithmetic == EdgeArithmetic::float32 || s.edge_arithmetic == EdgeArithmetic::float_stepped;
     },
     "edge-arithmetic=fixed"},
    {"edge-arithmetic", "int32-edge-functions",
     [](const Settings& s) { return s.edge_arithmetic == EdgeArithmetic::int32; }, "edge-arithmetic=fixed"},
    {"subpixel-bits", "sub-pixel-bits", [](const Settings& s) { return s.subpixel_bits < 8; }, "subpixel-bits=8"},
    {"shading", "gouraud-highlight", [](const Settings& s) { return s.shading == Shading::gouraud; }, "shading=phong"},
    {"renormalise", "unnormalised-interpolated-normals", [](const Settings& s) { return !s.renormalise; },
     "renormalise=on"},
    {"normal-transform", "normal-under-scale",
     [](const Settings& s) { return s.normal_transform != NormalTransform::inverse_transpose; },
     "normal-transform=inverse-transpose"},
    {"interpolation", "affine-texture", [](const Settings& s) { return s.interpolation == Interpolation::affine; },
     "interpolation=perspective"},
    {"subsampling", "subsampling-bars", [](const Settings& s) { return s.subsampling > 1; }, "subsampling=1"},
    {"adaptive-sampling", "adaptive-sampling-misses",
     [](const Settings& s) { return s.adaptive_sampling && s.samples_per_pixel > 1; }, "adaptive-sampling=off"},
    {"mip-bias", "mipmap-lod", [](const Settings& s) { return s.mip_bias < -1 || s.mip_bias > 1; }, "mip-bias=0"},
    {"texture-filter", "mipmap-lod",
     [](const Settings& s) {
       return s.texture_filter == TextureFilter::nearest || s.texture_filter == TextureFilter::bilinear;
     },
     "texture-filter=trilinear"},
    {"shadow-epsilon", "epsilon-too-large",
     [](const Settings& s) { return guarded_by_epsilon(s) && s.shadow_epsilon > 0.01; }, "self-hit=offset",
     "reflection-depth=0"},
    {"shadow-epsilon", "ground-sphere-acne",
     [](const Settings& s) { return guarded_by_epsilon(s) && s.shadow_epsilon <= 0.01; }, "self-hit=offset",
     "reflection-depth=0"},
    {"reflection-epsilon", "reflection-self-hit", guarded_by_epsilon, "self-hit=offset", "shadows=none"},
    {"self-hit", "constant-normal-bump", [](const Settings& s) { return s.self_hit == SelfHit::normal_bump; },
     "self-hit=offset"},
    {"shadow-bias", "shadow-map-acne", fixed_map_bias, "shadow-bias=0;shadow-slope-bias=-1"},
    {"stencil-bits", "stencil-bits-wrap", [](const Settings& s) { return s.stencil_bits < 8; }, "stencil-bits=8"},
    {"volume-caps", "z-fail-caps", [](const Settings& s) { return !s.volume_caps; }, "volume-caps=on"},
    {"volume-length", "z-fail-caps", [](const Settings& s) { return s.volume_length > 0; }, "volume-length=0"},
    {"volume-depth-clamp", "z-fail-caps", [](const Settings& s) { return !s.volume_depth_clamp && s.far < 1e30; },
     "volume-depth-clamp=on"},
    {"shadows", "z-pass-in-volume", [](const Settings& s) { return s.shadows == Shadows::stencil_depth_pass; },
     "shadows=stencil-depth-fail"},
    // A depth of 0 is a choice (the rasterizer has no other), not a picture with bounces missing.
    {"reflection-depth", "recursion-depth",
     [](const Settings& s) { return s.reflection_depth > 0 && s.reflection_depth < 3; }, "reflection-depth=8"},
    {"slab-test", "bvh-holes", [](const Settings& s) { return s.slab_test != SlabTest::robust; }, "slab-test=robust"},
    {"triangle-test", "triangle-edge-cracks",
     [](const Settings& s) { return s.triangle_test != TriangleTest::watertight; }, "triangle-test=watertight"},
    {"triangle-epsilon", "absolute-det-epsilon", [](const Settings& s) { return s.triangle_epsilon > 0; },
     "triangle-epsilon=0"},
    {"sphere-test", "ray-sphere-cancellation", [](const Settings& s) { return s.sphere_test != SphereTest::robust; },
     "sphere-test=robust"},
};

Settings made_safe(Settings settings, const std::string& assignments) {
  for (std::size_t begin = 0; begin < assignments.size();) {
    const std::size_t end = std::min(assignments.find(';', begin), assignments.size());
    parse_assignment(std::string_view(assignments).substr(begin, end - begin), settings);
    begin = end + 1;
  }
  return settings;
}

bool differ(Rgb8 a, Rgb8 b) {
  constexpr int visible = 8;
  return largest_difference(a, b) > visible;
}

View reduced(View view, int side) {
  const int longer = std::max(view.width, view.height);
  if (longer <= side) return view;
  view.width = std::max(1, view.width * side / longer);
  view.height = std::max(1, view.height * side / longer);
  return view;
}

}  // namespace

std::vector<UnsafeSetting> unsafe_settings(const Scene& scene, const View& view, const Settings& settings,
                                           Progress& progress, const UnsafeOptions& options) {
  const SceneTraits traits = scene_traits(scene);
  const View small = reduced(view, options.side);
  Prepared prepared;
  RenderRequest request;
  request.priority = options.priority;
  const auto picture = [&](const Settings& s) {
    return display_frame(render(scene, small, s, request, prepared, progress), s);
  };
  std::vector<UnsafeSetting> found;
  for (const Rule& rule : rules) {
    const Option* option = find_option(rule.option);
    PS_ASSERT(option != nullptr, "a rule names an option of the table");
    if (!rule.leaves(settings) || inactive_reason(*option, settings, traits)) continue;
    UnsafeSetting unsafe{rule.experiment, rule.option, option_text(*option, settings), std::string(rule.safe), 0};
    if (!options.only_known) {
      const Settings probed = made_safe(settings, std::string(rule.probe));
      const Settings safe = made_safe(probed, unsafe.safe);
      Settings exact = safe;
      exact.precision = Precision::float64;
      const Image<Rgb8> shown = picture(probed), same = picture(safe), truth = picture(exact);
      double bad = 0;
      for (std::size_t i = 0; i < shown.pixels().size(); ++i)
        bad += differ(shown.pixels()[i], truth.pixels()[i]) && !differ(same.pixels()[i], truth.pixels()[i]) ? 1 : 0;
      unsafe.bad_percent = 100 * bad / static_cast<double>(shown.pixels().size());
    }
    found.push_back(std::move(unsafe));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const UnsafeSetting& a, const UnsafeSetting& b) { return a.bad_percent > b.bad_percent; });
  return found;
}

}  // namespace ps
