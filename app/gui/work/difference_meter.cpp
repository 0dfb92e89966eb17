#include "gui/work/difference_meter.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "image/difference.h"

namespace ps::gui {

bool same_difference(const DifferenceRequest& a, const DifferenceRequest& b) {
  return a.versions == b.versions && a.region == b.region;
}

DifferenceMeter::DifferenceMeter(std::function<void()> wake)
    : LatestResult(
          [](const DifferenceRequest& request, Progress&) {
            const auto& [a, b] = *request.pictures;
            return MeasuredDifference{request, compare_pictures(a, b, {.region = request.region}),
                                      request.flip_map ? difference_values(a.levels, b.levels, DifferenceMode::flip)
                                                       : Image<float>()};
          },
          [](const DifferenceRequest& one, const DifferenceRequest& other) {
            return same_difference(one, other) && one.flip_map == other.flip_map;
          },
          std::move(wake)) {}

std::shared_ptr<const std::array<MeasuredPicture, 2>>
DifferenceMeter::copies(const Image<Rgb8>& a, const Image<Rgb8>& b, const std::array<std::uint64_t, 2>& versions) {
  if (!copies_ || copied_ != versions)
    copies_ = std::make_shared<const std::array<MeasuredPicture, 2>>(
        std::array{MeasuredPicture{a, {}}, MeasuredPicture{b, {}}});
  copied_ = versions;
  return copies_;
}

std::string difference_text(ErrorMetric metric, double error) {
  switch (metric) {
  case ErrorMetric::mae:
  case ErrorMetric::rmse:
    return fmt::format("{:.4g} levels of 255", error);
  case ErrorMetric::max:
    return fmt::format("{:.0f} levels of 255", error);
  case ErrorMetric::psnr:
    return std::isinf(error) ? "infinite: no level differs" : fmt::format("{:.4g} dB", error);
  case ErrorMetric::ssim:
    return fmt::format("{:.4f} (1 = equal)", error);
  case ErrorMetric::flip:
    return fmt::format("{:.4f} (0 = equal)", error);
  }
  return {};
}

const char* metric_help(ErrorMetric metric) {
  switch (metric) {
  case ErrorMetric::mae:
    return "Mean absolute difference of the red, green and blue levels, of 255. A few large differences hardly change "
           "it.";
  case ErrorMetric::rmse:
    return "Root of the mean squared difference of the red, green and blue levels, of 255. Large differences count "
           "more than small ones.";
  case ErrorMetric::psnr:
    return "20 log10(255 / RMSE), in decibels: higher is better; above about 40 dB differences are hardly visible.";
  case ErrorMetric::max:
    return "The largest difference of one channel of one pixel, in levels of 255.";
  case ErrorMetric::ssim:
    return "Similarity of mean, contrast and structure around each pixel: 1 for equal pictures.";
  case ErrorMetric::flip:
    return "Mean difference as seen when the two pictures are flipped in place: 0 for equal pictures, 1 at most.";
  }
  return "";
}

}  // namespace ps::gui
