#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "study/control.h"
#include "study/stability/experiment.h"
#include "study/timing.h"

namespace ps {

/// The curves of one experiment, as far as they are measured.
struct MeasuredExperiment {
  std::string key;
  std::vector<StabilityRow> rows;
  double seconds = 0;     ///< how long the whole experiment took; 0 while it is not complete
  bool complete = false;  ///< no row is missing
  std::string absent;     ///< why this machine cannot measure it: there are no rows then; empty: it can
};

struct StabilityRequest {
  std::vector<std::string> keys;  ///< of the experiments, in the order in which they are measured
  std::uint32_t seed = 1;
  double effort = 1;
  /// Where rows are kept as they arrive, and complete experiments are found again; empty = nowhere.
  std::filesystem::path folder;
  /// Complete experiments that the folder holds are taken from there, or measured again.
  enum class Kept { take, measure_again } kept = Kept::take;
};

/// Called after each row and each complete experiment, on the thread that runs the study; the status counts
/// experiments.
using StabilityUpdate = std::function<void(const MeasuredExperiment&, const StudyStatus&)>;

/// Measures experiments one after another. A cancelled study throws Cancelled; complete experiments in the folder are
/// taken up by the next call, the one that was cut off begins anew. Results of another seed, effort, version or
/// processor in the folder are set aside, in `runs.jsonl.damaged`. Throws InputError for an unknown key and a folder
/// that cannot be written.
std::vector<MeasuredExperiment> run_stability(const StabilityRequest& request, StudyControl& control,
                                              const StabilityUpdate& update = {}, const Clock& clock = steady_seconds);

/// What a folder holds of the request's seed and effort on this machine, also experiments that were cut off.
std::vector<MeasuredExperiment> read_stability(const StabilityRequest& request);

}  // namespace ps
