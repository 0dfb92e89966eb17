#pragma once
#include <string>
#include <vector>

#include "study/chart.h"

namespace ps {

/// A point of the sweep that has no place in the chart.
struct MissingPoint {
  int number = 0;
  std::string label;   ///< "" where even its settings are lost
  std::string reason;  ///< "no timed run", "timed, but its picture's line is lost" or "in no log"
  bool in_no_log = false;
};

/// The points of the whole sweep that are not measured, in its order. For a shard these include those of the others.
std::vector<MissingPoint> missing_points(const Chart& chart);

/// "points 1, 3 to 5 of 12 are missing: in no log; point 2 (octree): no timed run"; "" if none is missing.
std::string missing_text(const Chart& chart);

}  // namespace ps
