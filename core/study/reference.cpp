#include "study/reference.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "base/check.h"
#include "frame/display_frame.h"
#include "frame/viewport.h"
#include "image/display.h"
#include "image/file.h"
#include "options/renderer_kind.h"

namespace ps {
namespace {

/// Two means over each pixel, of samples that have none in common.
struct Halves {
  Image<Vec3d> first, second;
  double first_share = 0.5;  ///< of all samples

  Image<Vec3d> mean() const {
    Image<Vec3d> all = first;
    for (std::size_t i = 0; i < all.pixels().size(); ++i)
      all.pixels()[i] = first.pixels()[i] * first_share + second.pixels()[i] * (1 - first_share);
    return all;
  }
};

using Colours = std::function<Image<Vec3d>(const View&, const Settings&)>;

Image<Vec3d> colours_of(const Frame& frame) {
  if (!frame.colour_double.empty()) return frame.colour_double;
  Image<Vec3d> colours(frame.width(), frame.height());
  std::transform(frame.colour.pixels().begin(), frame.colour.pixels().end(), colours.pixels().begin(),
                 [](const Vec3f& colour) { return Vec3d(colour); });
  return colours;
}

/// All samples on a grid, and as many at Halton's places.
Halves sampled_halves(const View& view, const ReferencePlan& plan, const Colours& colours, Progress& progress) {
  progress.expect_parts(2);
  Settings settings = plan.settings;
  settings.samples_per_pixel = plan.samples;
  Halves halves;
  settings.sample_pattern = SamplePattern::grid;
  halves.first = colours(view, settings);
  progress.next_part();
  settings.sample_pattern = SamplePattern::halton;
  halves.second = colours(view, settings);
  return halves;
}

/// The view and settings that render `side` x `side` samples for each pixel of `view`, one pixel for each sample.
/// With the book's sample position the picture has one more column and row, since its samples lie on pixel corners.
/// Footprints of textures, tessellation and sub-pixel positions keep their size in pixels of `view`.
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
  large.settings.mip_bias += std::log2(side);
  large.settings.tessellation *= side;
  large.settings.subpixel_bits = std::max(0, settings.subpixel_bits - static_cast<int>(std::lround(std::log2(side))));
  return large;
}

/// The two colours of a chessboard of samples, from a picture that has `side` x `side` pixels for each.
Halves enlarged_halves(const View& view, const Settings& settings, int side, const Colours& colours) {
  const Enlarged large = enlarge(view, settings, side);
  const Image<Vec3d> samples = colours(large.view, large.settings);
  const int in_second = side * side / 2, in_first = side * side - in_second;
  Halves halves{Image<Vec3d>(view.width, view.height), Image<Vec3d>(view.width, view.height),
                static_cast<double>(in_first) / (side * side)};
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
          ((i + j) % 2 == 0 ? halves.first : halves.second).at(x, y) +=
              samples.at(x * side + i, (y + large.first_row) * side + j);
      halves.first.at(x, y) /= in_first;
      halves.second.at(x, y) /= in_second;
    }
  return halves;
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
  StoredPicture stored = load_picture(file);
  reference.picture.levels = display_image(stored.colour);
  reference.picture.linear = std::move(stored.colour);
  reference.description = fmt::format("the picture {}", file.string());
  for (const std::string& note : stored.notes) reference.description += fmt::format(" (it {})", note);
  const auto& levels = reference.picture.levels;
  if (levels.width() != view.width || levels.height() != view.height)
    throw InputError(fmt::format("{}: found a picture of {}x{}, expected the size of the study, {}x{}", file.string(),
                                 levels.width(), levels.height(), view.width, view.height));
  return reference;
}

}  // namespace

Reference make_reference(const Scene& scene, const View& view, const ReferencePlan& plan,
                         const ReferenceOptions& options, const ErrorOptions& error, WorkerPriority priority,
                         Progress& progress) {
  if (!options.file.empty()) return read_reference(options.file, view);
  const int side = static_cast<int>(std::lround(std::sqrt(plan.samples)));
  if (side < 1 || side * side != plan.samples)
    throw InputError(fmt::format("reference samples: found {}, expected a square number", plan.samples));
  Prepared prepared;
  RenderRequest request;
  request.priority = priority;
  Reference reference;
  const ReferencePlan made = affordable(plan, scene, view, request, prepared, progress);
  reference.description = made.description();
  const auto colours = [&](const View& seen, const Settings& settings) {
    return colours_of(render(scene, seen, settings, request, prepared, progress));
  };
  if (side == 1) {
    reference.picture = measured(colours(view, made.settings), made.settings);
    return reference;
  }
  const bool rays = sends_rays(made.settings.renderer);
  const Halves halves =
      rays ? sampled_halves(view, made, colours, progress) : enlarged_halves(view, made.settings, side, colours);
  reference.picture = measured(halves.mean(), made.settings);
  reference.halves =
      compare_pictures(measured(halves.first, made.settings), measured(halves.second, made.settings), error);
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
