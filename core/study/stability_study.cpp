#include "study/stability_study.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "study/stability_log.h"

namespace ps {
namespace {

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

std::vector<MeasuredExperiment> run_stability(const StabilityRequest& request, StudyControl& control,
                                              const StabilityUpdate& update, const Clock& clock) {
  return StabilityRunner(request, control, update, clock).run();
}

}  // namespace ps
