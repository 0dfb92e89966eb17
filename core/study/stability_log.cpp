#include "study/stability_log.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/machine.h"
#include "study/json_log.h"

namespace ps {
namespace {

using StabilityJson = nlohmann::ordered_json;

std::filesystem::path stability_log_path(const StabilityRequest& request) { return request.folder / "runs.jsonl"; }

/// Results with another head do not mix.
StabilityJson stability_head(const StabilityRequest& request) {
  const Machine machine = this_machine();
  return {{"stability", {{"seed", request.seed}, {"effort", request.effort}}},
          {"machine", {{"version", machine.version}, {"processor", machine.processor}, {"simd", machine.simd}}}};
}

/// JSON cannot represent NaN or infinity.
StabilityJson number_or_word(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}
double number_from(const StabilityJson& json) {
  if (json == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (json == "inf") return std::numeric_limits<double>::infinity();
  if (json == "-inf") return -std::numeric_limits<double>::infinity();
  return json.get<double>();
}

StabilityJson row_json(const std::string& experiment, const StabilityRow& row) {
  return {{"experiment", experiment},           {"knob", number_or_word(row.knob)},     {"series", row.series},
          {"naive", number_or_word(row.naive)}, {"robust", number_or_word(row.robust)}, {"unit", row.unit}};
}

/// What a log holds of the request's experiments.
struct StabilityFound {
  std::vector<MeasuredExperiment> experiments;
  std::vector<std::string> unread;  ///< damaged lines, and all lines of a log of another head
};

/// Takes lines one after another.
class StabilityReader {
 public:
  void take(const StabilityJson& line) {
    const std::string key = line.at("experiment");
    const auto found = std::find_if(all_.begin(), all_.end(), [&](const auto& e) { return e.key == key; });
    if (line.contains("begin")) {
      if (found != all_.end()) all_.erase(found);
      all_.push_back({.key = key, .rows = {}, .seconds = 0, .complete = false, .absent = {}});
      damaged_ = false;
    } else if (found == all_.end()) {
      throw InputError("found a row before its experiment begins");
    } else if (line.contains("seconds")) {
      const double seconds = line.at("seconds");
      if (!(seconds >= 0)) throw InputError("found a negative time");
      found->seconds = seconds;
      found->complete = !damaged_;
    } else {
      found->rows.push_back({number_from(line.at("knob")), line.at("series"), number_from(line.at("naive")),
                             number_from(line.at("robust")), line.at("unit")});
    }
  }
  /// The line may have been a row of the experiment that was measured then, which is not complete without it.
  void lose_line() {
    damaged_ = true;
    if (!all_.empty()) all_.back().complete = false;
  }
  std::vector<MeasuredExperiment> experiments() && { return std::move(all_); }

 private:
  std::vector<MeasuredExperiment> all_;  ///< the one that was measured last at the end
  bool damaged_ = false;
};

StabilityFound read_stability_log(const StabilityRequest& request) {
  StabilityFound found;
  const auto path = stability_log_path(request);
  std::error_code error;
  if (request.folder.empty() || !std::filesystem::exists(path, error)) return found;
  const JsonLog log = read_json_log(path);
  const bool ours = !log.lines.empty() && log.lines.front().json == stability_head(request);
  StabilityReader reader;
  const auto lose = [&](const std::string& text) {
    found.unread.push_back(text);
    reader.lose_line();
  };
  auto damaged = log.damaged.begin();
  const auto lose_damaged_before = [&](int number) {
    for (; damaged != log.damaged.end() && damaged->number < number; ++damaged) lose(damaged->text);
  };
  for (std::size_t i = 0; i < log.lines.size(); ++i) {
    const JsonLogLine& line = log.lines[i];
    lose_damaged_before(line.number);
    if (!ours) {
      lose(line.text);
      continue;
    }
    try {
      if (i > 0) reader.take(line.json);
    } catch (const std::exception&) {  // InputError and what nlohmann throws
      lose(line.text);
    }
  }
  lose_damaged_before(std::numeric_limits<int>::max());
  found.experiments = std::move(reader).experiments();
  return found;
}

}  // namespace

std::vector<MeasuredExperiment> read_stability(const StabilityRequest& request) {
  return read_stability_log(request).experiments;
}

StabilityLog::StabilityLog(const StabilityRequest& request) : path_(stability_log_path(request)) {
  lock_ = lock_log_folder(request.folder, "measuring");
  const auto [kept, unread] = read_stability_log(request);
  if (!unread.empty()) keep_aside(path_, unread, ".damaged");
  write_file_atomically(path_, stability_head(request).dump() + "\n");  // without what is damaged or was done twice
  file_.open(path_, std::ios::app);
  for (const MeasuredExperiment& experiment : kept) {
    begin(experiment.key);
    for (const StabilityRow& row : experiment.rows) add(experiment.key, row);
    if (experiment.complete) complete(experiment);
  }
}

void StabilityLog::begin(const std::string& experiment) {
  write(StabilityJson{{"experiment", experiment}, {"begin", true}}.dump());
}

void StabilityLog::add(const std::string& experiment, const StabilityRow& row) {
  write(row_json(experiment, row).dump());
}

void StabilityLog::complete(const MeasuredExperiment& experiment) {
  write(StabilityJson{{"experiment", experiment.key}, {"seconds", experiment.seconds}}.dump());
}

void StabilityLog::write(const std::string& line) {
  file_ << line << '\n' << std::flush;
  if (!file_) throw InputError(path_.string() + ": cannot be written");
}

}  // namespace ps
