#include "study/pair_timing.h"

#include <algorithm>

#include "base/check.h"
#include "render/render.h"

namespace ps {
namespace {

/// Milliseconds of each stage, of all timed calls.
using StageSamples = std::vector<std::pair<std::string, std::array<std::vector<double>, 2>>>;

void add(StageSamples& all, std::size_t side, const std::vector<StageTime>& times) {
  for (const StageTime& time : times) {
    auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first == time.stage; });
    if (found == all.end()) found = all.insert(found, {time.stage, {}});
    found->second[side].push_back(time.milliseconds);
  }
}

std::vector<PairStage> medians(const StageSamples& all) {
  std::vector<PairStage> stages;
  for (const auto& [stage, samples] : all) {
    PairStage one{stage, {}};
    for (std::size_t side = 0; side < 2; ++side)
      if (!samples[side].empty()) one.median_ms[side] = quartiles(samples[side]).median;
    stages.push_back(std::move(one));
  }
  return stages;
}

void summarise(PairTiming& timing, const StageSamples& stages) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < timing.samples_ms[1].size(); ++i) {
    const double a = timing.samples_ms[0][i], b = timing.samples_ms[1][i];
    if (a > 0) ratios.push_back(b / a);
  }
  for (std::size_t side = 0; side < 2; ++side) timing.time_ms[side] = quartiles(timing.samples_ms[side]);
  if (!ratios.empty()) timing.ratio = quartiles(ratios);
  timing.stages = medians(stages);
}

}  // namespace

bool PairTiming::shows_an_order() const {
  return !equal_settings && !within_noise(time_ms[0], time_ms[1]) && !within_noise(ratio, {1, 1, 1});
}

PairTiming time_in_turn(const std::array<TimedCall, 2>& calls, const PairTimingOptions& options, StudyControl& control,
                        const PairTimingUpdate& update, const Clock& clock) {
  PS_ASSERT(options.rounds >= 1 && options.fewest_rounds >= 1, "a timing has rounds");
  PairTiming timing;
  StageSamples stages;
  std::array<int, 2> repeats{};
  StudyStatus status{0, 2 * options.rounds, -1};
  const double start = clock();
  for (std::size_t side = 0; side < 2; ++side) {
    control.wait_here();
    repeats[side] = calls_per_sample([&] { calls[side](); }, options.shortest_sample, clock);
  }
  const double warm = clock();
  for (int round = 0; round < options.rounds; ++round) {
    if (round >= options.fewest_rounds && clock() - start > options.longest) break;
    for (const int turn : {0, 1}) {
      const auto side = static_cast<std::size_t>((turn + round) % 2);
      control.wait_here();
      calls[side]();
      timing.samples_ms[side].push_back(
          sample_milliseconds([&] { add(stages, side, calls[side]()); }, repeats[side], clock));
      ++status.done;
      status.seconds_left = (clock() - warm) / status.done * (status.total - status.done);
      if (update) update(status);
    }
  }
  summarise(timing, stages);
  return timing;
}

PairTiming time_pair(const PairTimingRequest& request, const PairTimingOptions& options, StudyControl& control,
                     const PairTimingUpdate& update, const Clock& clock) {
  Prepared prepared;
  const auto call = [&](std::size_t side) {
    return [&, side] {
      RenderRequest how;
      how.channels = request.channels[side];
      how.region = request.region;
      how.priority = request.priority;
      return render(request.scene, request.view, request.settings[side], how, prepared, control.progress()).times;
    };
  };
  PairTiming timing = time_in_turn({call(0), call(1)}, options, control, update, clock);
  timing.equal_settings = request.settings[0] == request.settings[1] && request.channels[0] == request.channels[1];
  return timing;
}

}  // namespace ps
