#pragma once
#include <filesystem>
#include <fstream>

#include "study/chart.h"

namespace ps {

/// The results of a chart in a folder, written as they arrive: `runs.jsonl` holds one JSON object a line (first the
/// identity, then pictures and timed runs in the order in which they were made), `picture-N.png` the picture of point N
/// and `reference.png` what it is compared with. A line cut off by a crash is ignored.
class ChartLog {
 public:
  /// Creates the folder if it is missing. Results that are there are put into `chart`, whose points must be in place.
  /// Throws InputError if they belong to another chart or the folder cannot be written.
  ChartLog(const std::filesystem::path& folder, Chart& chart, const Image<Rgb8>& reference);

  void add_picture(const ChartPoint& point);
  void add_sample(const ChartPoint& point, double milliseconds);

 private:
  void write(const std::string& line);

  std::filesystem::path folder_;
  std::ofstream file_;
};

/// Reads what a folder holds. Throws InputError if there is no chart in it.
Chart read_chart_log(const std::filesystem::path& folder);
/// Name of a point's picture: "picture-3.png".
std::string picture_name(const ChartPoint& point);

}  // namespace ps
