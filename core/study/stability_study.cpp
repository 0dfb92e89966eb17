#include "study/stability_study.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <optional>

#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/file_lock.h"
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

/// The results of stability experiments in a folder, written as they arrive: `runs.jsonl` holds one JSON object a line,
/// first what all of them have in common, then each experiment's beginning, its rows, and its time when it is complete.
/// The experiment of a damaged line is measured again. While the object lives, `runs.lock` keeps other programs out.
class StabilityLog {
 public:
  /// Creates the folder if it is missing. Damaged lines, and a log of another seed, effort, version or processor, go
  /// into `runs.jsonl.damaged`. Throws InputError if the folder cannot be written or another program measures there.
  explicit StabilityLog(const StabilityRequest& request) : path_(stability_log_path(request)) {
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

  void begin(const std::string& experiment) {
    write(StabilityJson{{"experiment", experiment}, {"begin", true}}.dump());
  }
  void add(const std::string& experiment, const StabilityRow& row) { write(row_json(experiment, row).dump()); }
  void complete(const MeasuredExperiment& experiment) {
    write(StabilityJson{{"experiment", experiment.key}, {"seconds", experiment.seconds}}.dump());
  }

 private:
  void write(const std::string& line) {
    file_ << line << '\n' << std::flush;
    if (!file_) throw InputError(path_.string() + ": cannot be written");
  }

  std::filesystem::path path_;
  std::optional<FileLock> lock_;
  std::ofstream file_;
};

/// Carries one request out.
class StabilityRunner {
 public:
  StabilityRunner(const StabilityRequest& request, StudyControl& control, const StabilityUpdate& update,
                  const Clock& clock)
      : request_(request), control_(control), update_(update), clock_(clock) {}

  std::vector<MeasuredExperiment> run() {
    for (const std::string& key : request_.keys) find_stability_experiment(key);
    for (MeasuredExperiment& experiment : read_stability(request_)) kept_[experiment.key] = std::move(experiment);
    if (!request_.folder.empty()) log_.emplace(request_);
    status_.total = static_cast<int>(request_.keys.size());
    std::vector<MeasuredExperiment> all;
    for (const std::string& key : request_.keys) {
      all.push_back(is_taken(key) ? kept_.at(key) : measure(key));
      ++status_.done;
      begun_ = clock_();
      report(all.back());
    }
    return all;
  }

 private:
  MeasuredExperiment measure(const std::string& key) {
    MeasuredExperiment measured{key, {}, 0, false, {}};
    if (const auto reason = why_not_measured(find_stability_experiment(key))) {
      measured.absent = *reason;
      return measured;
    }
    if (log_) log_->begin(key);
    begun_ = clock_();
    report(measured);
    StabilityRun run;
    run.seed = request_.seed;
    run.progress = &control_.progress();
    run.effort = request_.effort;
    run.control = &control_;
    run.arrived = [&](const StabilityRow& row) {
      measured.rows.push_back(row);
      if (log_) log_->add(key, row);
      report(measured);
    };
    run.check();
    measured.rows = find_stability_experiment(key).measure(run);
    measured.seconds = std::max(clock_() - begun_, 1e-6);
    measured.complete = true;
    if (log_) log_->complete(measured);
    took_[key] = measured.seconds;
    return measured;
  }

  /// From earlier runs of the same experiment; else as long as the others took on the average.
  std::optional<double> expected_seconds(const std::string& key) const {
    if (const auto known = took_.find(key); known != took_.end()) return known->second;
    if (const auto known = kept_.find(key); known != kept_.end() && known->second.complete)
      return known->second.seconds;
    double sum = 0;
    int count = 0;
    for (const auto& [other, seconds] : took_) sum += seconds, ++count;
    for (const auto& [other, experiment] : kept_)
      if (experiment.complete && !took_.contains(other)) sum += experiment.seconds, ++count;
    if (count == 0) return {};
    return sum / count;
  }

  bool is_taken(const std::string& key) const {
    const auto found = kept_.find(key);
    return request_.kept == StabilityRequest::Kept::take && found != kept_.end() && found->second.complete;
  }

  void report(const MeasuredExperiment& newest) {
    if (!update_) return;
    double left = 0;
    bool known = true;
    for (std::size_t i = static_cast<std::size_t>(status_.done); i < request_.keys.size(); ++i) {
      if (is_taken(request_.keys[i])) continue;
      const auto expected = expected_seconds(request_.keys[i]);
      known = known && expected;
      const bool now = static_cast<int>(i) == status_.done;
      if (expected) left += std::max(0.0, *expected - (now ? clock_() - begun_ : 0));
    }
    status_.seconds_left = known ? left : -1;
    update_(newest, status_);
  }

  const StabilityRequest& request_;
  StudyControl& control_;
  const StabilityUpdate& update_;
  const Clock& clock_;
  std::map<std::string, MeasuredExperiment> kept_;  ///< in the folder, by key
  std::map<std::string, double> took_;              ///< seconds, measured now
  double begun_ = 0;                                ///< when the experiment of now began
  StudyStatus status_;
  std::optional<StabilityLog> log_;
};

}  // namespace

std::vector<MeasuredExperiment> read_stability(const StabilityRequest& request) {
  return read_stability_log(request).experiments;
}

std::vector<MeasuredExperiment> run_stability(const StabilityRequest& request, StudyControl& control,
                                              const StabilityUpdate& update, const Clock& clock) {
  return StabilityRunner(request, control, update, clock).run();
}

}  // namespace ps
