#include "study/metric.h"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

namespace ps {
namespace {

constexpr std::array<ErrorMetricRow, 6> metric_rows{{
    {ErrorMetric::mae, "mae", "mean absolute error", false, true, true},
    {ErrorMetric::rmse, "rmse", "RMSE", false, true, true},
    {ErrorMetric::psnr, "psnr", "PSNR (dB)", true, false, false},
    {ErrorMetric::max, "max", "largest error", false, true, true},
    {ErrorMetric::ssim, "ssim", "SSIM", true, false, false},
    {ErrorMetric::flip, "flip", "FLIP", false, false, true},
}};

template <class T>
Image<T> cut(const Image<T>& image, const TileRect& rect) {
  Image<T> part(rect.width(), rect.height());
  for (int y = 0; y < rect.height(); ++y) {
    const auto from = image.row(rect.y0 + y).subspan(static_cast<std::size_t>(rect.x0), part.row(y).size());
    std::copy(from.begin(), from.end(), part.row(y).begin());
  }
  return part;
}

template <class T, class Compare>
Comparison compare_region(const Image<T>& a, const Image<T>& b, const std::optional<TileRect>& region,
                          Compare compare) {
  if (a.width() != b.width() || a.height() != b.height() || !region) return compare(a, b);
  if (region->x0 < 0 || region->y0 < 0 || region->width() < 1 || region->height() < 1 || region->x1 > a.width() ||
      region->y1 > a.height())
    throw InputError(fmt::format("region: found {},{},{},{}, expected a rectangle inside the picture of {}x{}",
                                 region->x0, region->y0, region->width(), region->height(), a.width(), a.height()));
  return compare(cut(a, *region), cut(b, *region));
}

}  // namespace

std::span<const ErrorMetricRow> error_metrics() { return metric_rows; }

const ErrorMetricRow& error_metric(ErrorMetric metric) { return metric_rows[static_cast<std::size_t>(metric)]; }

ErrorMetric parse_error_metric(std::string_view key) {
  std::string known;
  for (const ErrorMetricRow& row : metric_rows) {
    if (row.key == key) return row.metric;
    known += fmt::format(" {}", row.key);
  }
  throw InputError(fmt::format("metric: found '{}', expected one of{}", key, known));
}

Comparison compare_pictures(const MeasuredPicture& reference, const MeasuredPicture& test,
                            const ErrorOptions& options) {
  switch (options.values) {
  case ErrorValues::display: {
    Comparison result = compare_region(reference.levels, test.levels, options.region, compare_images);
    if (result.identical && !reference.linear.empty() && !test.linear.empty())
      result.identical =
          compare_region(reference.linear, test.linear, options.region, compare_channels<Vec3f>).identical;
    return result;
  }
  case ErrorValues::linear:
    return compare_region(reference.linear, test.linear, options.region, compare_linear);
  }
  return {};
}

double error_of(const Comparison& comparison, ErrorMetric metric) {
  switch (metric) {
  case ErrorMetric::mae:
    return comparison.mae;
  case ErrorMetric::rmse:
    return comparison.rmse;
  case ErrorMetric::psnr:
    return comparison.psnr.value_or(std::numeric_limits<double>::infinity());
  case ErrorMetric::max:
    return comparison.max;
  case ErrorMetric::ssim:
    return comparison.ssim;
  case ErrorMetric::flip:
    return comparison.flip;
  }
  return 0;
}

bool better_error(ErrorMetric metric, double a, double b) {
  return error_metric(metric).higher_is_better ? a > b : a < b;
}

}  // namespace ps
