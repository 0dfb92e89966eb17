#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "render/render.h"
#include "study/metric.h"

namespace ps {

struct ReferenceOptions {
  std::filesystem::path file;  ///< a picture to compare with; empty = render one
  int samples = 16;            ///< for each pixel, on a square grid: a square number
};

/// What pictures are compared with.
struct Reference {
  MeasuredPicture picture;
  std::string description;  ///< "ray tracer in double, 16 samples for each pixel"
  /// How far the pictures of two halves of the samples are apart (a chessboard of samples each); absent for a file and
  /// for one sample.
  std::optional<Comparison> halves;
};

/// The settings of the best picture that can be had of what `base` asks for: the ray tracer in double with its robust
/// tests and at least 12 bounces. What `base` says about the scene's look (lights on, textures, exposure) stays. Scenes
/// that rays cannot show (canvas items alone, wireframes) keep the rasterizer.
Settings reference_settings(const Settings& base, const SceneTraits& traits);

/// Renders in `samples` times as many pixels and takes means of linear colour, centred where one sample would lie, or
/// reads the file, which must have the view's size. Throws InputError.
Reference make_reference(const Scene& scene, const View& view, const Settings& base, const ReferenceOptions& options,
                         const ErrorOptions& error, WorkerPriority priority, Progress& progress);

/// What the reference itself may be wrong by, in the metric's unit: half the difference of its halves for differences
/// that add up, the metric between the halves (an upper bound) for the others. Nothing if it is not known.
std::optional<double> reference_noise(const Reference& reference, ErrorMetric metric);

}  // namespace ps
