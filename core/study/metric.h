#pragma once
#include <optional>
#include <span>
#include <string_view>

#include "base/parallel.h"
#include "frame/frame.h"
#include "image/metrics.h"
#include "options/settings.h"

namespace ps {

/// The metric that measures the error of a picture as one number.
enum class ErrorMetric { mae, rmse, psnr, max, ssim, flip };

struct ErrorMetricRow {
  ErrorMetric metric{};
  std::string_view key;    ///< "rmse"
  std::string_view label;  ///< "RMSE"
  bool higher_is_better = false;
  bool in_levels = false;   ///< its unit is that of the values: display levels 0..255, or unit floats
  bool logarithmic = true;  ///< how its axis should be drawn
};
std::span<const ErrorMetricRow> error_metrics();
const ErrorMetricRow& error_metric(ErrorMetric metric);
/// Throws InputError naming the metrics that exist.
ErrorMetric parse_error_metric(std::string_view key);

enum class ErrorValues { display, linear };

/// Where and in which values pictures are compared.
struct ErrorOptions {
  ErrorMetric metric = ErrorMetric::rmse;
  ErrorValues values = ErrorValues::display;
  std::optional<TileRect> region;  ///< pixels; nothing = the whole picture
};

/// A picture in both forms in which it can be compared.
struct MeasuredPicture {
  Image<Rgb8> levels;
  Image<Vec3f> linear;
};

/// All metrics at once, over the region. The pictures must have the same size and hold the region (InputError).
Comparison compare_pictures(const MeasuredPicture& reference, const MeasuredPicture& test, const ErrorOptions& options);
/// The one that is asked for; PSNR of equal pictures is +infinity.
double error_of(const Comparison& comparison, ErrorMetric metric);
/// Is `a` a smaller error than `b`?
bool better_error(ErrorMetric metric, double a, double b);

}  // namespace ps
