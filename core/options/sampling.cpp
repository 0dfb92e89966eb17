#include "options/rows.h"

namespace ps::rows {
namespace {

constexpr std::string_view multisampling_instead = "ray tracer only; the rasterizer has multisampling";

Reason needs_several_samples(const Settings& s, const SceneTraits&) {
  if (s.samples_per_pixel == 1) return needs("samples-per-pixel", 4).said("needs samples-per-pixel above 1");
  return {};
}

Reason needs_adaptive(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_several_samples(s, t)) return reason;
  if (!s.adaptive_sampling) return needs("adaptive-sampling", true).said("needs adaptive-sampling");
  return {};
}

Reason needs_one_sample(const Settings& s, const SceneTraits&) {
  if (s.samples_per_pixel > 1) return needs("samples-per-pixel", 1);
  if (s.sample_pattern != SamplePattern::grid)
    return needs("sample-pattern", SamplePattern::grid).because("it skips pixels at regular distances");
  return {};
}

}  // namespace

std::vector<Option> sampling_rows() {
  Option samples = integer<&Settings::samples_per_pixel>(
      {.key = "samples-per-pixel",
       .label = "Samples per pixel",
       .help = {"Number of rays that are averaged for each pixel. Square numbers (1, 4, 9, 16 ...) make a square grid.",
                "CGFS ch. 5",
                "n samples cost n times as much; the RMS error along edges falls about as n^-0.75 on regular patterns, "
                "as n^-0.5 with random samples."},
       .keywords = "AA, SSAA, antialias, antialiasing, anti-aliasing, supersampling, jaggies, staircase, spp, noise",
       .truth = pixel_average(),
       .acts_for = ActsFor::rays,
       .only_for = multisampling_instead,
       .known_to = {.fast = {limit(hit_shading, 10, "SIMD shading needs one ray per pixel",
                                   [](const Settings& s, const SceneTraits&) {
                                     return s.samples_per_pixel > 1 && !s.adaptive_sampling;
                                   })},
                    .hardware = not_asked},
       .shown_by = {.experiments = {{"supersampling-rate"}, {"sub-pixel-disc-missed"}},
                    .scenes = {{"cgfs/reflections"}}}},
      1, 4096, "rays");
  samples.scale = OptionScale::logarithmic;
  samples.sweep_values = "1,4,16,64,256";  // the curve is clear by then, and 4096 take minutes
  const Option subsampling = integer<&Settings::subsampling>(
      {.key = "subsampling",
       .label = "Subsampling",
       .help = {"Traces only every n-th pixel. If the traced neighbours hit the same object, the pixels between them "
                "test that object alone. Every pixel is shaded.",
                "CGFS ch. 5", "An object thinner than n pixels may fall between the traced rays and vanish."},
       .keywords = "half resolution, undersampling, skip pixels, interlace, speed",
       .truth = pixel_average(),
       .acts_for = ActsFor::rays,
       .only_for = multisampling_instead,
       .inactive = needs_one_sample,
       .known_to = {.fast = {limit(hit_shading, 20, "SIMD shading needs subsampling = 1",
                                   [](const Settings& s, const SceneTraits& t) {
                                     return s.subsampling > 1 && !needs_one_sample(s, t);
                                   })},
                    .hardware = not_asked},
       .shown_by = {.experiments = {{"subsampling-bars", [](const Settings& s) { return s.subsampling > 1; },
                                     "subsampling=1"}},
                    .scenes = {{"cgfs/shading", "triangle-test=moeller-trumbore"}}}},
      1, 16, "pixels");
  return {
      samples,
      choice<&Settings::sample_pattern>(
          {.key = "sample-pattern",
           .label = "Sample pattern",
           .help = {"Positions of the samples inside a pixel.", "CGFS ch. 5; Cook 1986; Halton 1960; Roberts 2018",
                    "A grid turns fine detail into moire patterns; random samples turn it into noise."},
           .keywords = "AA, antialias, antialiasing, moire, moiré, noise, jitter, stratified, low discrepancy, quasi "
                       "Monte Carlo, supersampling",
           .truth = pixel_average(),
           .acts_for = ActsFor::rays,
           .only_for = multisampling_instead,
           .known_to = {.fast = {limit(hit_shading, 10, "SIMD shading needs one ray per pixel",
                                       [](const Settings& s, const SceneTraits&) {
                                         return s.samples_per_pixel == 1 && s.sample_pattern != SamplePattern::grid;
                                       })},
                        .hardware = not_asked},
           .shown_by = {.experiments = {{"supersampling-rate"}, {"grid-moire"}},
                        .scenes = {{"cgfs/reflections", "samples-per-pixel=4"}}}},
          {{"grid", "grid", "The centres of equal cells."},
           {"jitter", "jittered grid", "One random position in each of n equal cells."},
           {"random", "random", "Independent random positions: clusters and gaps."},
           {"halton", "Halton", "Radical inverses in bases 2 and 3, shifted per pixel: evenly spread for any count."},
           {"r2", "R2",
            "Multiples of the plastic number's inverse powers, shifted per pixel: evenly spread, simple to compute."}}),
      toggle<&Settings::adaptive_sampling>(
          {.key = "adaptive-sampling",
           .label = "Adaptive sampling",
           .help = {"Traces one ray for each pixel, then all samples of those pixels whose neighbours hit another "
                    "object or differ in colour. The view 'samples' shows which.",
                    "CGFS ch. 5", "Misses detail that falls between the first rays."},
           .keywords = "AA, antialias, antialiasing, supersampling, subdivision, Whitted",
           .truth = pixel_average(),
           .acts_for = ActsFor::rays,
           .only_for = multisampling_instead,
           .inactive = needs_several_samples,
           .known_to = {.fast = {limit(every_hit, 10, "further samples of a pixel are shaded one after the other",
                                       [](const Settings& s, const SceneTraits&) {
                                         return s.samples_per_pixel > 1 && s.adaptive_sampling;
                                       })},
                        .hardware = not_asked},
           .shown_by = {.experiments = {{"adaptive-sampling-misses",
                                         [](const Settings& s) {
                                           return s.adaptive_sampling && s.samples_per_pixel > 1;
                                         },
                                         "adaptive-sampling=off"}},
                        .scenes = {{"cgfs/reflections", "samples-per-pixel=4"}}}}),
      real<&Settings::adaptive_threshold>(
          {.key = "adaptive-threshold",
           .label = "Adaptive threshold",
           .help = {"Neighbours on the same object are subdivided if a linear colour channel (1 = white, before "
                    "exposure) differs by more than this.",
                    "CGFS ch. 5", "Too large: shadows stay jagged. 0 subdivides every shaded pixel."},
           .keywords = "AA, antialias, antialiasing, supersampling, contrast",
           .truth = pixel_average(),
           .acts_for = ActsFor::rays,
           .only_for = multisampling_instead,
           .inactive = needs_adaptive,
           .known_to = {.fast = any_value, .hardware = not_asked},
           .shown_by = {.experiments = {{"adaptive-sampling-misses"}},
                        .scenes = {{"cgfs/reflections", "samples-per-pixel=4;adaptive-sampling=on"}}}},
          0, 1, OptionScale::linear),
      subsampling,
  };
}

}  // namespace ps::rows
