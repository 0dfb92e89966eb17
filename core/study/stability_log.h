#pragma once
#include <filesystem>
#include <fstream>
#include <vector>

#include "study/stability_study.h"

namespace ps {

/// The results of stability experiments in a folder, written as they arrive: `runs.jsonl` holds one JSON object a line,
/// first what all of them have in common, then each experiment's beginning, its rows, and its time when it is complete.
/// A line cut off by a crash is ignored.
class StabilityLog {
 public:
  /// Creates the folder if it is missing. Throws InputError if it cannot be written.
  explicit StabilityLog(const StabilityRequest& request);

  void begin(const std::string& experiment);
  void add(const std::string& experiment, const StabilityRow& row);
  void complete(const MeasuredExperiment& experiment);

 private:
  void write(const std::string& line);

  std::filesystem::path path_;
  std::ofstream file_;
};

}  // namespace ps
