#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/render.h"
#include "study/metric.h"
#include "study/sweep.h"

namespace ps {

struct ReferenceOptions {
  std::filesystem::path file;  ///< a picture to compare with; empty = render one
  int samples = 0;             ///< for each pixel, a square number; 0 = as the swept options' truth asks
};

/// How the picture is made that all points of a chart are held against.
struct ReferencePlan {
  Settings settings;
  /// 1: rendered with `settings` as they are, so at the same samples as the points. More: their mean over each pixel.
  int samples = 1;
  int fewest_samples = 1;            ///< that are enough for these points; below `samples` where more is only welcome
  std::vector<const Option*> swept;  ///< the options that differ among the points
  std::vector<std::string> exact;    ///< what these options ask for: "self-hit=offset"

  std::string description() const;  ///< "ray tracer in double, sampled as the points are, self-hit=offset"
};

/// What pictures are compared with.
struct Reference {
  MeasuredPicture picture;
  std::string description;
  /// How far the pictures of two halves of the samples are apart; absent for a file and for samples = 1.
  std::optional<Comparison> halves;
};

/// Decides the truth of every study that compares pictures with one: charts, the table of renderers, and what a scene
/// needs. What all points have in common it has as well (reflection depth, cut-offs, tessellation, filters, samples at
/// the same places), in double with robust tests. Options that differ among the points take the exact settings of
/// their row in the option table, or their value in `base`. Where the truth of one is the average over the pixel, 64
/// samples and at least four times those of any point are averaged (at most 4096; for fragments as many as 2^25 pixels
/// hold); fewer, but never fewer than four times those of any point, where `view` makes them too many.
ReferencePlan plan_reference(std::span<const SweepPoint> points, const Settings& base, const SceneTraits& traits,
                             const View& view, const ReferenceOptions& options);

/// The plan with fewer samples, or in float, where its rays take too long. They are counted in a small picture, so the
/// answer is the same on every machine. Throws Cancelled.
ReferencePlan affordable(ReferencePlan plan, const Scene& scene, const View& view, const RenderRequest& how,
                         Prepared& prepared, Progress& progress);

/// Renders the picture of affordable(plan), or reads options.file, which must have the view's size. Throws InputError.
Reference make_reference(const Scene& scene, const View& view, const ReferencePlan& plan,
                         const ReferenceOptions& options, const ErrorOptions& error, WorkerPriority priority,
                         Progress& progress);

/// What the reference itself may be wrong by, in the metric's unit: half the difference of its halves for differences
/// that add up, the metric between the halves (an upper bound) for the others. nullopt if it is not known.
std::optional<double> reference_noise(const Reference& reference, ErrorMetric metric);

/// For people: what the truth of the option is, "the picture with self-hit=offset".
std::string truth_text(const Option& option);

}  // namespace ps
