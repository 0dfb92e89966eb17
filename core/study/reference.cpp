#include "study/reference.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/check.h"
#include "image/display.h"
#include "image/file.h"
#include "options/robust_rays.h"
#include "render/viewport.h"

namespace ps {
namespace {

constexpr int least_bounces = 12;

bool shown_by_rays(const Settings& base, const SceneTraits& traits) {
  const bool only_canvas = traits.canvas_items && !traits.spheres && !traits.triangles && !traits.solids && !traits.csg;
  const bool outlines = base.renderer == Renderer::rasterizer && base.draw != Draw::filled;
  return !only_canvas && !outlines;
}

/// Sums over the samples of a pixel; `first` and `second` are the two colours of a chessboard of samples.
struct Sums {
  Image<Vec3d> first, second;
};

/// The view and settings that render `side` x `side` samples for each pixel of `view`, one pixel for each sample.
/// With the book's sample position the picture has one more column and row, since its samples lie on pixel corners.
struct Enlarged {
  View view;
  Settings settings;
  int first_row = 0;  ///< of `view`'s row 0, in pixels of `view`
};

Enlarged enlarge(const View& view, const Settings& settings, int side) {
  const Viewport<double> viewport = make_viewport<double>(view, settings);
  const int more = settings.sample_position == SamplePosition::corner ? 1 : 0;
  Enlarged large{view, settings, more};
  large.view.width = (view.width + more) * side;
  large.view.height = (view.height + more) * side;
  large.view.camera.viewport_width = viewport.width / viewport.span_x * (view.width + more);
  large.view.camera.viewport_height = viewport.height / viewport.span_y * (view.height + more);
  large.settings.viewport_fit = ViewportFit::stretch;
  large.settings.field_of_view_span = FieldOfViewSpan::edges;
  large.settings.sample_position = SamplePosition::centre;
  return large;
}

Sums sum_samples(const Frame& frame, const View& view, int side, int first_row) {
  Sums sums{Image<Vec3d>(view.width, view.height), Image<Vec3d>(view.width, view.height)};
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x)
      for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
          const Vec3d& colour = frame.colour_double.at(x * side + i, (y + first_row) * side + j);
          ((i + j) % 2 == 0 ? sums.first : sums.second).at(x, y) += colour;
        }
  return sums;
}

Image<Vec3d> mean_of(const Image<Vec3d>& sums, double samples) {
  Image<Vec3d> mean = sums;
  for (Vec3d& colour : mean.pixels()) colour /= samples;
  return mean;
}

MeasuredPicture measured(const Image<Vec3d>& colours, const Settings& settings) {
  MeasuredPicture picture;
  picture.levels = display_image(colours, display_transform(settings));
  picture.linear = Image<Vec3f>(colours.width(), colours.height());
  std::transform(colours.pixels().begin(), colours.pixels().end(), picture.linear.pixels().begin(),
                 [](const Vec3d& colour) { return Vec3f(colour); });
  return picture;
}

Reference read_reference(const std::filesystem::path& file, const View& view) {
  Reference reference;
  reference.picture.levels = load_levels(file);
  reference.picture.linear = load_image(file);
  reference.description = fmt::format("the picture {}", file.string());
  const auto& levels = reference.picture.levels;
  if (levels.width() != view.width || levels.height() != view.height)
    throw InputError(fmt::format("{}: found a picture of {}x{}, expected the size of the study, {}x{}", file.string(),
                                 levels.width(), levels.height(), view.width, view.height));
  return reference;
}

}  // namespace

Settings reference_settings(const Settings& base, const SceneTraits& traits) {
  Settings best = robust_rays(base);
  best.renderer = shown_by_rays(base, traits) ? Renderer::ray_tracer : Renderer::rasterizer;
  best.samples_per_pixel = 1;
  best.multisampling = 1;
  best.adaptive_sampling = false;
  best.subsampling = 1;
  best.self_hit = SelfHit::offset;
  best.reflection_depth = std::max(base.reflection_depth, least_bounces);
  best.reflection_cutoff = 0;
  if (best.renderer == Renderer::ray_tracer && base.shadows != Shadows::none) best.shadows = Shadows::traced;
  best.colour_depth = ColourDepth::bits24;
  return best;
}

Reference make_reference(const Scene& scene, const View& view, const Settings& base, const ReferenceOptions& options,
                         const ErrorOptions& error, WorkerPriority priority, Progress& progress) {
  if (!options.file.empty()) return read_reference(options.file, view);
  const int side = static_cast<int>(std::lround(std::sqrt(options.samples)));
  if (side < 1 || side * side != options.samples)
    throw InputError(fmt::format("reference samples: found {}, expected a square number", options.samples));
  const Settings best = reference_settings(base, scene_traits(scene));
  const Enlarged large = side == 1 ? Enlarged{view, best, 0} : enlarge(view, best, side);
  Prepared prepared;
  RenderRequest request;
  request.priority = priority;
  const Frame frame = render(scene, large.view, large.settings, request, prepared, progress);
  const Sums sums = sum_samples(frame, view, side, large.first_row);
  Image<Vec3d> all = sums.first;
  for (std::size_t i = 0; i < all.pixels().size(); ++i) all.pixels()[i] += sums.second.pixels()[i];
  Reference reference;
  reference.picture = measured(mean_of(all, options.samples), best);
  reference.description = fmt::format("{} in double, {} sample{} for each pixel",
                                      best.renderer == Renderer::ray_tracer ? "ray tracer" : "rasterizer",
                                      options.samples, options.samples == 1 ? "" : "s");
  if (side > 1) {
    const int in_second = options.samples / 2;
    reference.halves = compare_pictures(measured(mean_of(sums.first, options.samples - in_second), best),
                                        measured(mean_of(sums.second, in_second), best), error);
  }
  return reference;
}

std::optional<double> reference_noise(const Reference& reference, ErrorMetric metric) {
  if (!reference.halves) return {};
  const double between = error_of(*reference.halves, metric);
  switch (metric) {
  case ErrorMetric::mae:
  case ErrorMetric::rmse:
  case ErrorMetric::max:
    return between / 2;
  case ErrorMetric::psnr:
    return between + 20 * std::log10(2.0);
  case ErrorMetric::ssim:
  case ErrorMetric::flip:
    return between;
  }
  return {};
}

}  // namespace ps
