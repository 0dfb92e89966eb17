#pragma once
#include <nlohmann/json.hpp>

#include <optional>

#include "study/chart.h"

namespace ps {

/// The lines of a chart's log as JSON objects, and back. What reads throws InputError or nlohmann's exceptions for a
/// line that no chart wrote.

/// Renders take less than this many milliseconds, which are 11 days.
inline constexpr double longest_sample_ms = 1e9;

nlohmann::ordered_json chart_head_json(const Chart& chart);
/// Identity, machine and reference halves into `chart`.
void read_chart_head(const nlohmann::ordered_json& json, Chart& chart);

nlohmann::ordered_json chart_picture_json(const ChartPoint& point);
/// A point of a chart of `points` points without its picture and samples; ChartPoint::compared is set.
ChartPoint chart_picture_from(const nlohmann::ordered_json& json, int points);

/// With the last of the point's uploads, if it has any.
nlohmann::ordered_json chart_sample_json(const ChartPoint& point, double milliseconds);
/// A timed run of the point of this number.
struct ChartSample {
  int number = 0;
  double milliseconds = 0;          ///< finite, from 0 to longest_sample_ms
  std::optional<double> upload_ms;  ///< alike
};
ChartSample chart_sample_from(const nlohmann::ordered_json& json, int points);

}  // namespace ps
