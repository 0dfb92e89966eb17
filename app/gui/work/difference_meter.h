#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "gui/work/latest_result.h"
#include "image/image.h"
#include "study/metric.h"

namespace ps::gui {

/// Two pictures of display levels that are to be compared.
struct DifferenceRequest {
  std::shared_ptr<const std::array<MeasuredPicture, 2>> pictures;
  std::array<std::uint64_t, 2> versions{};  ///< which pictures these are
  std::optional<TileRect> region;           ///< the only pixels that count; absent = all
  bool flip_map = false;                    ///< FLIP of each pixel too
};
/// Whether two requests are for the same pictures and pixels, with or without the map.
bool same_difference(const DifferenceRequest& a, const DifferenceRequest& b);

/// How far B is from A, by every metric.
struct MeasuredDifference {
  DifferenceRequest request;
  Comparison comparison;
  Image<float> flip_map;  ///< of the whole pictures; empty if it was not asked for
};

/// Measures in the background: FLIP and SSIM take far longer than a frame.
class DifferenceMeter : public LatestResult<DifferenceRequest, MeasuredDifference> {
 public:
  explicit DifferenceMeter(std::function<void()> wake);
  /// Copies that the background may read while the window goes on; new ones only where the versions are.
  std::shared_ptr<const std::array<MeasuredPicture, 2>> copies(const Image<Rgb8>& a, const Image<Rgb8>& b,
                                                               const std::array<std::uint64_t, 2>& versions);

 private:
  std::shared_ptr<const std::array<MeasuredPicture, 2>> copies_;
  std::array<std::uint64_t, 2> copied_{};
};

/// "12.3 levels of 255", "31.4 dB", "0.042 (0 = equal, 1 = most)"
std::string difference_text(ErrorMetric metric, double error);
/// What a metric says and in which unit, for a tooltip.
const char* metric_help(ErrorMetric metric);

}  // namespace ps::gui
