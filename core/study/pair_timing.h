#pragma once
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frame/frame.h"
#include "frame/view.h"
#include "options/settings.h"
#include "scene/scene.h"
#include "study/control.h"
#include "study/timing.h"

namespace ps {

/// One stage of a render, of both pictures.
struct PairStage {
  std::string stage;
  std::array<std::optional<double>, 2> median_ms;  ///< absent in a picture without this stage
};

/// Two pictures timed in turn: both are prepared and drawn once before, and what disturbs the machine for a while
/// disturbs both.
struct PairTiming {
  std::array<std::vector<double>, 2> samples_ms;  ///< wall time of one render; one sample for each round
  std::array<Quartiles, 2> time_ms;
  Quartiles ratio;  ///< of the second picture's time to the first one's, round by round
  std::vector<PairStage> stages;
  bool equal_settings = false;  ///< both pictures are the same, so that their times differ by noise alone

  int rounds() const { return static_cast<int>(samples_ms[1].size()); }
  /// Do the rounds show which picture takes longer? Neither its times nor the ratio may be within noise.
  bool shows_an_order() const;
};

struct PairTimingOptions {
  int rounds = 9;
  int fewest_rounds = 3;           ///< made even where they take long
  double longest = 20;             ///< seconds; beyond, no further round begins
  double shortest_sample = 0.005;  ///< seconds; shorter renders are repeated within one sample
};

/// Called after each sample.
using PairTimingUpdate = std::function<void(const StudyStatus&)>;

/// Renders one of the pictures, and answers how long its stages took.
using TimedCall = std::function<std::vector<StageTime>()>;

/// Times two calls in turn, the first of the two first in every other round; each sample follows an untimed call, since
/// the other one has filled the caches since. Throws Cancelled.
PairTiming time_in_turn(const std::array<TimedCall, 2>& calls, const PairTimingOptions& options, StudyControl& control,
                        const PairTimingUpdate& update = {}, const Clock& clock = steady_seconds);

/// Two pictures of a scene.
struct PairTimingRequest {
  Scene scene;
  View view;
  std::array<Settings, 2> settings;
  std::array<Channel, 2> channels{};  ///< besides colour
  std::optional<TileRect> region;     ///< the only pixels rendered; absent = all
  WorkerPriority priority = WorkerPriority::normal;
};
PairTiming time_pair(const PairTimingRequest& request, const PairTimingOptions& options, StudyControl& control,
                     const PairTimingUpdate& update = {}, const Clock& clock = steady_seconds);

}  // namespace ps
