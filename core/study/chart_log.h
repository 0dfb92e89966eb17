#pragma once
#include <filesystem>
#include <fstream>
#include <optional>

#include "base/file_lock.h"
#include "study/chart.h"

namespace ps {

/// The results of a chart in a folder, written as they arrive: `runs.jsonl` holds one JSON object a line (first the
/// identity, then pictures and timed runs in the order in which they were made), `picture-N.png` the picture of point N
/// and `reference.png` what it is compared with. While the object lives, `runs.lock` keeps other programs out.
class ChartLog {
 public:
  /// Creates the folder if it is missing. Results that are there are put into `chart`, whose points must be in place.
  /// Damaged lines go from the log into `runs.jsonl.damaged`, and Chart::damage names them. Throws InputError if the
  /// results belong to another chart, if the first line is damaged, if another program measures a chart there, or if
  /// the folder cannot be written; the log is then as it was.
  ChartLog(const std::filesystem::path& folder, Chart& chart, const Image<Rgb8>& reference);

  void add_picture(const ChartPoint& point);
  void add_sample(const ChartPoint& point, double milliseconds);

 private:
  /// Puts the results of the log there into `chart`; gives the lines that stay, without the first.
  std::string take_up(const std::filesystem::path& path, Chart& chart) const;
  void write(const std::string& line);

  std::filesystem::path folder_;
  std::optional<FileLock> lock_;
  std::ofstream file_;
};

/// Reads what a folder holds, but for damaged lines and missing pictures, which Chart::damage names. Throws InputError
/// if there is no chart in it or the log's first line is damaged.
Chart read_chart_log(const std::filesystem::path& folder);
/// Name of a point's picture: "picture-3.png".
std::string picture_name(const ChartPoint& point);

}  // namespace ps
