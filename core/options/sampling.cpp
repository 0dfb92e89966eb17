#include "options/renderer_kind.h"
#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_eye_rays(const Settings& s, const SceneTraits&) {
  if (!sends_rays(s.renderer)) return "only rays can be sent anywhere; fragments have multisampling";
  return {};
}

Reason needs_several_samples(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_eye_rays(s, t)) return reason;
  if (s.samples_per_pixel == 1) return "needs samples-per-pixel above 1";
  return {};
}

Reason needs_adaptive(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_several_samples(s, t)) return reason;
  if (!s.adaptive_sampling) return "needs adaptive-sampling";
  return {};
}

Reason needs_one_sample(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_eye_rays(s, t)) return reason;
  if (s.samples_per_pixel > 1) return "needs samples-per-pixel = 1";
  if (s.sample_pattern != SamplePattern::grid) return "needs sample-pattern = grid: it leaves out regular pixels";
  return {};
}

}  // namespace

std::vector<Option> sampling_rows() {
  Option samples = integer<&Settings::samples_per_pixel>(
      {.key = "samples-per-pixel",
       .label = "Samples per pixel",
       .help = {"Number of rays that are averaged for each pixel. 1, 4, 9, 16 and other squares make a square grid.",
                "CGFS ch. 5",
                "n samples cost n times as much; the error along edges falls about with n^-0.75, with random positions "
                "with n^-0.5."},
       .truth = pixel_average(),
       .inactive = needs_eye_rays},
      1, 4096, "rays");
  samples.scale = OptionScale::logarithmic;
  samples.sweep_values = "1,4,16,64,256";  // the curve is clear by then, and 4096 take minutes
  const Option subsampling = integer<&Settings::subsampling>(
      {.key = "subsampling",
       .label = "Subsampling",
       .help =
           {"The first hit is searched for at every n-th pixel; where those around a pixel saw the same object, only "
            "that object is tested. Shading is done for each pixel.",
            "CGFS ch. 5", "A thing thinner than the step may fall between the searched rays and vanish."},
       .truth = pixel_average(),
       .inactive = needs_one_sample},
      1, 16, "pixels");
  return {
      samples,
      choice<&Settings::sample_pattern>(
          {.key = "sample-pattern",
           .label = "Sample pattern",
           .help = {"Where in the pixel its rays go.", "CGFS ch. 5; Cook 1986; Halton 1960; Roberts 2018",
                    "A grid turns fine detail into false patterns; random places turn it into noise."},
           .truth = pixel_average(),
           .inactive = needs_eye_rays},
          {{"grid", "grid", "The middle of equal cells."},
           {"jitter", "jittered grid", "Anywhere in equal cells."},
           {"random", "random", "Anywhere, each for itself: clusters and gaps."},
           {"halton", "Halton", "Mirrored digits in bases 2 and 3, shifted for each pixel: even at every number."},
           {"r2", "R2", "Multiples of the plastic number's powers, shifted for each pixel: even and simple."}}),
      toggle<&Settings::adaptive_sampling>(
          {.key = "adaptive-sampling",
           .label = "Adaptive sampling",
           .help = {"One ray for each pixel first; only pixels whose neighbours met another object or differ in colour "
                    "get all samples. The view 'samples' shows where.",
                    "CGFS ch. 5", "Detail that falls between the first rays is not found."},
           .truth = pixel_average(),
           .inactive = needs_several_samples}),
      real<&Settings::adaptive_threshold>(
          {.key = "adaptive-threshold",
           .label = "Adaptive threshold",
           .help =
               {"The difference of a linear colour channel (1 = white, before exposure) from which neighbours on one "
                "object are subdivided.",
                "CGFS ch. 5", "Large ones leave jagged shadows; 0 samples all that is shaded."},
           .truth = pixel_average(),
           .inactive = needs_adaptive},
          0, 1, OptionScale::linear),
      subsampling,
  };
}

}  // namespace ps::rows
