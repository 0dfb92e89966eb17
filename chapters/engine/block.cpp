#include "engine/block.h"

#include <algorithm>

#include "document/number_list.h"

namespace ps {

bool has_line(const std::vector<BlockLine>& lines, std::string_view word) {
  return std::any_of(lines.begin(), lines.end(), [&](const BlockLine& line) { return line.word == word; });
}

bool read_metric_line(const BlockLine& line, Metric& metric) {
  if (line.word == "within") {
    metric.within = parse_region_text(line.rest);
    return true;
  }
  if (line.word != "metric") return false;
  const auto within = metric.within;  // the two lines come in either order
  metric = parse_metric(line.rest);
  metric.within = within;
  return true;
}

void require_within(const Metric& metric) {
  if (metric.within && !reads_pictures(metric.kind))
    throw InputError(fmt::format("within: '{}' is not measured on a part of the pictures", metric_text(metric)));
}

}  // namespace ps
