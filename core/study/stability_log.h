#pragma once
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

#include "base/file_lock.h"
#include "study/stability_study.h"

namespace ps {

/// The results of stability experiments in a folder, written as they arrive: `runs.jsonl` holds one JSON object a line,
/// first what all of them have in common, then each experiment's beginning, its rows, and its time when it is complete.
/// The experiment of a damaged line is measured again. While the object lives, `runs.lock` keeps other programs out.
class StabilityLog {
 public:
  /// Creates the folder if it is missing. Damaged lines, and a log of another seed, effort, version or processor, go
  /// into `runs.jsonl.damaged`. Throws InputError if the folder cannot be written or another program measures there.
  explicit StabilityLog(const StabilityRequest& request);

  void begin(const std::string& experiment);
  void add(const std::string& experiment, const StabilityRow& row);
  void complete(const MeasuredExperiment& experiment);

 private:
  void write(const std::string& line);

  std::filesystem::path path_;
  std::optional<FileLock> lock_;
  std::ofstream file_;
};

}  // namespace ps
