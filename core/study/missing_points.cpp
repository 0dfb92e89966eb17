#include "study/missing_points.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ps {
namespace {

/// "1, 3 to 5" of rising numbers.
std::string ranges_text(const std::vector<int>& numbers) {
  std::vector<std::string> parts;
  for (std::size_t first = 0, last = 0; first < numbers.size(); first = last + 1) {
    for (last = first; last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1;) ++last;
    parts.push_back(first == last
                        ? fmt::format("{}", numbers[first])
                        : fmt::format("{} {} {}", numbers[first], last == first + 1 ? "and" : "to", numbers[last]));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::vector<MissingPoint> missing_points(const Chart& chart) {
  std::vector<const ChartPoint*> of_number(static_cast<std::size_t>(chart.identity.points), nullptr);
  for (const ChartPoint& point : chart.points) of_number[static_cast<std::size_t>(point.number)] = &point;
  std::vector<MissingPoint> missing;
  for (int number = 0; number < chart.identity.points; ++number) {
    const ChartPoint* point = of_number[static_cast<std::size_t>(number)];
    if (point && point->measured()) continue;
    const bool timed = point && !point->samples_ms.empty(), compared = point && point->compared;
    const char* reason = timed ? "timed, but its picture's line is lost" : compared ? "no timed run" : "in no log";
    missing.push_back({number, point ? point->what.label : "", reason, !timed && !compared});
  }
  return missing;
}

std::string missing_text(const Chart& chart) {
  std::vector<int> in_no_log;
  std::vector<std::string> parts;
  for (const MissingPoint& point : missing_points(chart))
    if (point.in_no_log)
      in_no_log.push_back(point.number);
    else
      parts.push_back(fmt::format("point {}{} is missing: {}", point.number,
                                  point.label.empty() ? "" : fmt::format(" ({})", point.label), point.reason));
  if (!in_no_log.empty())
    parts.insert(parts.begin(),
                 fmt::format("{} {} of {} (from 0) missing: in no log", in_no_log.size() == 1 ? "point" : "points",
                             ranges_text(in_no_log), chart.identity.points));
  return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace ps
