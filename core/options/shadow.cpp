#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_casting_light(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_filled_fragments(s)) return reason;
  if (!s.lighting) return needs("lighting", true);
  if (!t.casting_lights) return "the scene has no light that casts shadows";
  return {};
}

/// The reason of algorithms that need a stencil buffer.
Reason needs_no_rays(const Settings& s, const SceneTraits&) {
  if (sends_rays(s.renderer))
    return needs("renderer", renderer_for(PictureWay::fragments)).because("rays trace their shadows");
  return {};
}

Reason needs_shadow_rays(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_casting_light(s, t)) return reason;
  return needs_traced_shadows(s);
}

Reason needs_lamp(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_shadow_rays(s, t)) return reason;
  if (!t.lamps) return "no light of the scene has a radius";
  return {};
}

Reason needs_shadow_samples(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_lamp(s, t)) return reason;
  if (s.shadow_samples < 2) return needs("shadow-samples", 16).said("needs shadow-samples above 1");
  return {};
}

/// Has a point several shadow rays to a lamp?
bool samples_lamps(const Settings& s, const SceneTraits& t) { return s.shadow_samples > 1 && t.lamps; }

Reason needs_shadow_map(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_casting_light(s, t)) return reason;
  // A listing that reads the size or the bias of a map always has one.
  if (!runs_listing(s.renderer) && s.shadows != Shadows::map) return needs("shadows", Shadows::map);
  return {};
}

Reason needs_stencil(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_casting_light(s, t)) return reason;
  if (s.shadows != Shadows::stencil_depth_fail && s.shadows != Shadows::stencil_depth_pass)
    return needs("shadows", Shadows::stencil_depth_fail, Shadows::stencil_depth_pass);
  if (s.visibility != Visibility::depth_buffer) return needs("visibility", Visibility::depth_buffer);
  return {};
}

Reason needs_depth_fail(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_stencil(s, t)) return reason;
  if (s.shadows != Shadows::stencil_depth_fail) return needs("shadows", Shadows::stencil_depth_fail);
  return {};
}

Reason needs_cut_volumes(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_depth_fail(s, t)) return reason;
  if (s.far >= no_far_limit) return needs("far", some_far_limit).said("needs a far limit");
  return {};
}

Reason needs_secondary_rays(const Settings& s, const SceneTraits& t) {
  const bool bounces = t.reflective || t.transparent;
  if (!t.casting_lights && !bounces) return "the scene has no light that casts shadows, and no mirror or glass";
  const bool shadows = s.lighting && t.casting_lights && !needs_traced_shadows(s);
  const bool mirrors = bounces && s.reflection_depth > 0;
  if (!shadows && !mirrors)
    return IdleReason({{"shadows", static_cast<double>(Shadows::traced)},
                       {"reflection-depth", static_cast<double>(Settings{}.reflection_depth)},
                       {"lighting", 1}})
        .said("needs shadows or reflections");
  return {};
}

Reason needs_shadow_epsilon(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_shadow_rays(s, t)) return reason;
  if (s.self_hit == SelfHit::offset || s.self_hit == SelfHit::exclusion)
    return needs("self-hit", SelfHit::epsilon, SelfHit::normal_bump);
  return {};
}

Reason needs_epsilon(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_secondary_rays(s, t)) return reason;
  if (s.self_hit != SelfHit::epsilon) return needs("self-hit", SelfHit::epsilon);
  return {};
}

bool looks_up_maps(const Settings& s, const SceneTraits& t) {
  return s.lighting && t.casting_lights && s.shadows == Shadows::map;
}

bool maps_or_counts(const Settings& s, const SceneTraits& t) {
  if (looks_up_maps(s, t)) return true;
  if (!s.lighting || !t.casting_lights) return false;
  const bool stencil = s.shadows == Shadows::stencil_depth_fail || s.shadows == Shadows::stencil_depth_pass;
  return stencil && s.visibility == Visibility::depth_buffer;
}

/// The hardware renderer draws light that is computed at vertices light by light, each where its shadow map lets it
/// through.
Reason map_lacks(OptionNumber shadows, const Settings& s) {
  const bool at_vertices = s.lighting && s.shading != Shading::phong;
  if (shadows == static_cast<OptionNumber>(Shadows::map) && at_vertices && s.visibility != Visibility::depth_buffer)
    return IdleReason({{"shading", static_cast<double>(Shading::phong)},
                       {"visibility", static_cast<double>(Visibility::depth_buffer)}})
        .said("shadow maps of the hardware renderer need shading = phong or visibility = depth-buffer");
  return {};
}

bool fixed_map_bias(const Settings& s) {
  return s.shadow_slope_bias >= 0 && s.shadow_slope_bias < 0.5 * s.shadow_filter;
}

/// Rays look up the same maps as fragments.
SeenScenes scenes_of_maps() {
  return {{"cgfs/shadows", "shadows=map;shadow-map-size=64", PictureWay::rays},
          {"cgfs/shadows", "shadows=map;shadow-map-size=64", PictureWay::fragments}};
}

Option shadow_samples_row() {
  Option option = integer<&Settings::shadow_samples>(
      {.key = "shadow-samples",
       .label = "Shadow samples",
       .help =
           {"Shadow rays from a point to each area light, a point light with a radius. They end on the disc that it "
            "shows there, and the share that arrives is the share of its light.",
            "CGFS ch. 4; Cook, Porter and Carpenter 1984",
            "1: hard shadows. Too few: steps in the penumbra on a grid, noise at random "
            "places. Each sample is a ray."},
       .keywords = "area light, soft shadow, penumbra, umbra, distribution ray tracing",
       .truth = exactly("shadow-samples=256"),
       .acts_for = ActsFor::rays,
       .inactive = needs_lamp,
       .known_to = {.fast = {limit(sphere_packets, 65, "packets send one shadow ray to a light", samples_lamps),
                             limit(hit_shading, 45, "SIMD shading sends one shadow ray to a light", samples_lamps)},
                    .hardware = not_asked},
       .shown_by = {.experiments = none, .scenes = {{"lab/cornell"}}}},
      1, 256, "rays");
  option.scale = OptionScale::logarithmic;
  option.sweep_values = "1,4,16,64,256";
  return option;
}

}  // namespace

std::vector<Option> shadow_rows() {
  return {
      choice<&Settings::shadows>(
          {.key = "shadows",
           .label = "Shadows",
           .help = {"How the renderer finds out whether a light is blocked.", "CGFS ch. 4 and 15; CGPP 15.6.5",
                    "The ray tracer sends a shadow ray to each light unless this is 'none' or 'map'. The rasterizer "
                    "has no rays: with 'traced' it shows no shadows."},
           .keywords = "shadow map, shadow volume, stencil shadow, shadow ray, hard shadow",
           .truth = exactly("shadows=traced|stencil-depth-fail"),
           .inactive = needs_casting_light,
           .known_to = {.fast = {limit(sphere_packets, 61, "packets do not look up shadow maps", looks_up_maps),
                                 limit(hit_shading, 41, "SIMD shading does not look up shadow maps", looks_up_maps),
                                 limit(fragment_batches, 120, "SIMD does not support shadow maps or stencil shadows",
                                       maps_or_counts)},
                        .hardware = lacking_if(map_lacks)},
           .shown_by = {.experiments = {{"z-pass-in-volume", is<&Settings::shadows, Shadows::stencil_depth_pass>,
                                         "shadows=stencil-depth-fail"},
                                        {"near-plane-cuts-volume"}},
                        .scenes = {{"cgfs/reflections"}, {"lab/stacked-shadows"}}}},
          {{"traced", "traced", "One shadow ray for each light; ray tracer only."},
           {"none", "none", "No light is ever blocked."},
           {"map", "shadow map",
            "Depth as seen from the light, six maps around a point light. Fragments and rays look up their points in "
            "them: blocky edges, and acne without a bias."},
           {"stencil-depth-fail", "stencil, depth fail",
            "Counts the shadow volume faces behind the surface: exact edges, right for every camera position.",
            needs_no_rays},
           {"stencil-depth-pass", "stencil, depth pass",
            "Counts the faces in front of the surface: wrong if the camera is inside a shadow.", needs_no_rays}}),
      integer<&Settings::shadow_map_size>(
          {.key = "shadow-map-size",
           .label = "Shadow map size",
           .help = {"Texels along each side of a shadow map; a point light has six maps.", "CGFS ch. 15",
                    "Too small: blocky shadows and more acne. Too large: memory and time; at 4096 x 4096 texels a "
                    "point light takes 400 MB."},
           .keywords = "resolution, blocky, aliasing, jaggies, shadow map",
           .truth = exactly("shadows=traced|stencil-depth-fail"),
           .inactive = needs_shadow_map,
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = scenes_of_maps()}},
          8, 4096, "texels"),
      real<&Settings::shadow_bias>(
          {.key = "shadow-bias",
           .label = "Shadow map bias",
           .help = {"Subtracted from a point's depth, as seen from the light, before the comparison with the map.",
                    "CGFS ch. 15; Direct3D 11 15.10",
                    "Too small: shadow acne, stripes on lit surfaces. Too large: detached shadows (peter-panning)."},
           .keywords = "acne, shadow acne, peter-panning, peter panning, depth bias, polygon offset, self-shadowing",
           .truth = exactly("shadows=traced|stencil-depth-fail"),
           .inactive = needs_shadow_map,
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = {{"shadow-map-acne", fixed_map_bias, "shadow-bias=0;shadow-slope-bias=-1"},
                                        {"peter-panning"}},
                        .scenes = scenes_of_maps()}},
          0, 10, OptionScale::logarithmic, "world units"),
      real<&Settings::shadow_slope_bias>(
          {.key = "shadow-slope-bias",
           .label = "Slope bias",
           .help =
               {"A bias that grows with the surface's slope as seen from the light: the depth range of this number of "
                "texels. Added to the constant bias.",
                "Direct3D 11 15.10",
                "A filter of k x k taps needs k / 2 texels if the slope runs along a map axis, as on a floor, else up "
                "to 0.71 k. -1 computes this, with the rounding of vertices and depths and the tessellation error."},
           .keywords = "acne, shadow acne, peter-panning, slope scale, polygon offset, depth bias",
           .truth = exactly("shadows=traced|stencil-depth-fail"),
           .inactive = needs_shadow_map,
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = {{"shadow-map-acne"}, {"pcf-one-tap-bias"}, {"peter-panning"}},
                        .scenes = scenes_of_maps()}},
          -1, 16, OptionScale::linear, "texels"),
      integer<&Settings::shadow_filter>(
          {.key = "shadow-filter",
           .label = "Shadow map filter",
           .help = {"Percentage-closer filtering: compares k x k texels and averages the results.", "CGFS ch. 15",
                    "Softens the blocky edges, but needs more bias; the cost grows as k^2."},
           .keywords = "PCF, percentage closer filtering, soft edge, blur, penumbra",
           .truth = pixel_average("shadows=traced|stencil-depth-fail"),
           .inactive = needs_shadow_map,
           .known_to = {.fast = any_value, .hardware = defined_as("SHADOW_FILTER")},
           .shown_by = {.experiments = {{"pcf-one-tap-bias"}}, .scenes = scenes_of_maps()}},
          1, 7, "taps"),
      integer<&Settings::stencil_bits>(
          {.key = "stencil-bits",
           .label = "Stencil bits",
           .help = {"Bits of a pixel's counter of shadow volumes.", "CGFS ch. 15",
                    "Too few: the counter wraps, and a pixel inside 2^bits shadow volumes is lit."},
           .keywords = "overflow, wrap, stencil buffer, shadow volume, counter",
           .truth = exactly("stencil-bits=16"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_stencil,
           .known_to = {.fast = any_value, .hardware = lacking("drivers keep 8 stencil bits of a pixel", 9, 16)},
           .shown_by = {.experiments = {{"stencil-bits-wrap", [](const Settings& s) { return s.stencil_bits < 8; },
                                         "stencil-bits=8"}},
                        .scenes = {{"lab/stacked-shadows"}}}},
          1, 16, "bits"),
      toggle<&Settings::volume_caps>(
          {.key = "volume-caps",
           .label = "Volume caps",
           .help = {"Closes shadow volumes at both ends: with the lit triangles, and with their copies at the far end.",
                    "CGFS ch. 15; Everitt and Kilgard 2002",
                    "Depth fail counts faces behind the surface. Without caps it misses lines of sight that pass "
                    "through an open end, and surfaces shadow themselves."},
           .keywords = "z-fail, Carmack, shadow volume, cap, depth fail",
           .truth = exactly("volume-caps=on"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_depth_fail,
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = {{"z-fail-caps", is<&Settings::volume_caps, false>, "volume-caps=on"}},
                        .scenes = {{"cgfs/shadows", "shadows=stencil-depth-fail;far=7"}}}}),
      real<&Settings::volume_length>(
          {.key = "volume-length",
           .label = "Volume length",
           .help = {"Length of a shadow volume from the object that casts the shadow; 0 = unbounded.",
                    "CGFS ch. 15; Everitt and Kilgard 2002",
                    "Too small: no shadow beyond the volume's end. Programs shorten volumes because short ones cover "
                    "fewer pixels."},
           .keywords = "infinite, extrusion, shadow volume",
           .truth = exactly("volume-length=0"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_stencil,
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = {{"z-fail-caps", [](const Settings& s) { return s.volume_length > 0; },
                                         "volume-length=0"}},
                        .scenes = {{"cgfs/shadows", "shadows=stencil-depth-fail;far=7"}}}},
          0, 1e6, OptionScale::logarithmic, "world units"),
      toggle<&Settings::volume_depth_clamp>(
          {.key = "volume-depth-clamp",
           .label = "Volume depth clamp",
           .help = {"Moves the faces of shadow volumes beyond the far limit onto it.", "Everitt and Kilgard 2002",
                    "Off: the far limit cuts volumes open, and depth fail misses the faces behind it."},
           .keywords = "far plane, depth clamp, shadow volume",
           .truth = exactly("volume-depth-clamp=on"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_cut_volumes,
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by =
               {.experiments = {{"z-fail-caps",
                                 [](const Settings& s) { return !s.volume_depth_clamp && s.far < no_far_limit; },
                                 "volume-depth-clamp=on"}},
                .scenes = {{"cgfs/shadows", "shadows=stencil-depth-fail;far=7"}}}}),
      choice<&Settings::self_hit>(
          {.key = "self-hit",
           .label = "Self-hit guard",
           .help = {"How a ray that starts on a surface avoids hitting it again at its origin.",
                    "CGFS ch. 4; CGPP 15.4.8; pbrt 6.8; Waechter and Binder, Ray Tracing Gems 6",
                    "With the book's epsilon in float, 5.7 % of the pixels on the ground reflect the ground itself. "
                    "Exclusion loses shadows and mirror images of a surface in itself: of a hollow body, of the far "
                    "side of glass."},
           .keywords = "acne, shadow acne, surface acne, self-intersection, self-shadowing, epsilon, bias",
           .truth = exactly("self-hit=offset"),
           .acts_for = ActsFor::rays,
           .inactive = needs_secondary_rays,
           .known_to = {.fast = {knows(sphere_packets, 60, SelfHit::offset),
                                 knows(triangle_search, 60, SelfHit::offset, SelfHit::epsilon, SelfHit::normal_bump)},
                        .hardware = not_asked},
           .shown_by = {.experiments =
                            {{"constant-normal-bump", is<&Settings::self_hit, SelfHit::normal_bump>, "self-hit=offset"},
                             {"guards-at-a-surface", is<&Settings::self_hit, SelfHit::exclusion>, "self-hit=offset"}},
                        .scenes = {{"cgfs/reflections"}}}},
          {{"offset", "bounded offset", "Starts outside the error bound of the hit point; nothing to tune."},
           {"epsilon", "epsilon", "Ignores hits with t up to epsilon, as in the book."},
           {"normal-bump", "normal bump", "Starts epsilon above the surface along its normal, as in CGPP."},
           {"exclusion", "exclusion",
            "Does not test the sphere, triangle or solid that it leaves; neighbours and coincident surfaces still "
            "count."}}),
      real<&Settings::shadow_epsilon>(
          {.key = "shadow-epsilon",
           .label = "Shadow epsilon",
           .help = {"Distance from its origin at which a shadow ray starts to search.", "CGFS ch. 4",
                    "Too small: shadow acne, surfaces shadow themselves. Too large: detached shadows (peter-panning)."},
           .keywords = "acne, shadow acne, self-shadowing, bias, peter-panning, self-intersection",
           .truth = exactly("self-hit=offset"),
           .acts_for = ActsFor::rays,
           .inactive = needs_shadow_epsilon,
           .known_to = {.fast = any_value, .hardware = not_asked},
           .shown_by =
               {.experiments =
                    {{"epsilon-too-large",
                      [](const Settings& s) { return s.self_hit == SelfHit::epsilon && s.shadow_epsilon > 0.01; },
                      "self-hit=offset", "reflection-depth=0"},
                     {"ground-sphere-acne",
                      [](const Settings& s) { return s.self_hit == SelfHit::epsilon && s.shadow_epsilon <= 0.01; },
                      "self-hit=offset", "reflection-depth=0"}},
                .scenes = {{"cgfs/reflections", "self-hit=epsilon"}}}},
          0, 10, OptionScale::logarithmic),
      choice<&Settings::epsilon_unit>(
          {.key = "epsilon-unit",
           .label = "Epsilon measures",
           .help = {"The unit of both epsilons.", "CGFS ch. 4",
                    "As a ray parameter, 0.001 is 0.0057 units long for the light direction (1, 4, 4)."},
           .keywords = "acne, bias, scale, ray parameter",
           .truth = exactly("self-hit=offset"),
           .acts_for = ActsFor::rays,
           .inactive = needs_epsilon,
           .known_to = {.fast = any_value, .hardware = not_asked},
           .shown_by = {.experiments = {{"epsilon-unit"}}, .scenes = {{"cgfs/reflections", "self-hit=epsilon"}}}},
          {{"ray-parameter", "ray parameter t", "In multiples of the ray's direction vector, as in the book."},
           {"distance", "distance", "In world units."}}),
      toggle<&Settings::shadow_any_hit>(
          {.key = "shadow-any-hit",
           .label = "Stop at any hit",
           .help = {"Stops a shadow ray at the first blocker found instead of searching for the nearest.", "CGFS ch. 5",
                    "Only speed changes."},
           .keywords = "early out, occlusion ray, any hit, first hit",
           .truth = as_set(),
           .acts_for = ActsFor::rays,
           .inactive = needs_shadow_rays,
           .effect = OptionEffect::speed,
           .known_to = {.fast = any_value, .hardware = not_asked},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/shading"}}}}),
      shadow_samples_row(),
      choice<&Settings::shadow_pattern>(
          {.key = "shadow-pattern",
           .label = "Shadow sample pattern",
           .help = {"Where on the disc of an area light shadow rays end.", "Cook 1986; Halton 1960; Roberts 2018",
                    "A grid draws bands; random places draw noise."},
           .keywords = "area light, soft shadow, noise, banding, jitter, stratified, low discrepancy",
           .truth = exactly("shadow-samples=256"),
           .acts_for = ActsFor::rays,
           .inactive = needs_shadow_samples,
           .known_to = {.fast = any_value, .hardware = not_asked},
           .shown_by = {.experiments = none, .scenes = {{"lab/cornell", "shadow-samples=16"}}}},
          {{"grid", "grid", "The centres of equal parts of the disc."},
           {"jitter", "jittered grid", "One random position in each of n equal parts."},
           {"random", "random", "Independent random positions: clusters and gaps."},
           {"halton", "Halton", "Radical inverses in bases 2 and 3, shifted per point."},
           {"r2", "R2", "Multiples of the plastic number's inverse powers, shifted per point."}}),
      choice<&Settings::shadow_rays>(
          {.key = "shadow-rays",
           .label = "Shadow rays",
           .help = {"The lights to which a shaded point sends a shadow ray.", "CGFS ch. 4",
                    "Colours stay the same, because a light that adds nothing needs no shadow ray. Only the view "
                    "'shadows' no longer marks those points."},
           .keywords = "occlusion, skip, back-facing, light",
           .truth = as_set(),
           .acts_for = ActsFor::rays,
           .inactive = needs_shadow_rays,
           .known_to = {.fast = any_value, .hardware = not_asked},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}},
          {{"all", "to every light", "As in the book: also if the light comes from behind the surface."},
           {"useful", "to lights that add something",
            "Only if the light is in front of the surface or makes a highlight."}}),
  };
}

}  // namespace ps::rows
