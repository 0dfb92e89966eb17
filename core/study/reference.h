#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>

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
  std::string description;  ///< "ray tracer in double, sampled as the points are, self-hit=offset"
};

/// What pictures are compared with.
struct Reference {
  MeasuredPicture picture;
  std::string description;
  /// How far the pictures of two halves of the samples are apart; absent for a file and for samples = 1.
  std::optional<Comparison> halves;
};

/// Can rays show what the settings ask for? Neither canvas items alone nor the rasterizer's outlines.
bool shown_by_rays(const Settings& settings, const SceneTraits& traits);

/// The settings of the best picture that can be had of what `base` asks for: the ray tracer in double with its robust
/// tests and at least 12 bounces. What `base` says about the scene's look (lights on, textures, exposure) stays. Scenes
/// that rays cannot show (canvas items alone, wireframes) keep the rasterizer.
Settings reference_settings(const Settings& base, const SceneTraits& traits);

/// The reference of a chart. What all points have in common it has as well (reflection depth, cut-offs, tessellation,
/// filters, samples at the same places), in double with robust tests. Options that differ among the points take the
/// exact settings of their row in the option table, or their value in `base`; where the truth of one is the average
/// over the pixel, at least 16 samples and four times those of any point are averaged (at most 4096; for fragments as
/// many as 2^25 pixels hold). `view` bounds the memory and the time that the samples may take.
ReferencePlan plan_reference(std::span<const SweepPoint> points, const Settings& base, const SceneTraits& traits,
                             const View& view, const ReferenceOptions& options);

/// Renders the plan's picture, or reads options.file, which must have the view's size. Throws InputError.
Reference make_reference(const Scene& scene, const View& view, const ReferencePlan& plan,
                         const ReferenceOptions& options, const ErrorOptions& error, WorkerPriority priority,
                         Progress& progress);

/// What the reference itself may be wrong by, in the metric's unit: half the difference of its halves for differences
/// that add up, the metric between the halves (an upper bound) for the others. Nothing if it is not known.
std::optional<double> reference_noise(const Reference& reference, ErrorMetric metric);

/// For people: what the truth of the option is, "the picture with self-hit=offset".
std::string truth_text(const Option& option);

}  // namespace ps
