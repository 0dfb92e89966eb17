#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "render/render.h"
#include "study/control.h"
#include "study/counted_work.h"
#include "study/features.h"
#include "study/metric.h"

namespace ps {

struct NeedsRequest {
  Scene scene;
  View view;
  Settings base;
  double tolerance = 0.05;  ///< largest allowed worst_tile_flip
  int repeats = 5;          ///< timed runs of each variant, interleaved
  WorkerPriority priority = WorkerPriority::normal;
};

struct FeatureShare {
  Feature feature;
  bool used = false;
  bool absent = false;        ///< the scene cannot use it with any settings
  std::string reason;         ///< why it is free to drop, if it is not used
  double error_without = 0;   ///< worst_tile_flip against the reference when it is switched off
  double cost_share = 0;      ///< share of the time of a picture that it takes
  bool cost_differs = false;  ///< the quartiles of both times lie apart; else the share is within noise
  double work_share = 0;      ///< the same of the counted work
  std::shared_ptr<const Image<Rgb8>> picture;  ///< without it; null if it is not used
};

/// Why a feature that is not used is free to drop.
std::string needs_free_sentence(const FeatureShare& share);

/// One step of the search.
struct NeedsStep {
  std::string change;  ///< "shadows=none"
  double error = 0;
  std::uint64_t work = 0;
  bool accepted = false;
};

struct Needs {
  double tolerance = 0;
  Settings advice;
  double error = 0, default_error = 0;  ///< worst_tile_flip against the reference
  double time_ms = 0, default_time_ms = 0;
  bool time_differs = false;  ///< the quartiles of both times lie apart; else they are the same within noise
  std::string machinery;      ///< which code was timed, the same for all: TimedSettings::reason
  std::uint64_t work = 0, default_work = 0;
  std::vector<FeatureShare> shares;
  std::shared_ptr<const Image<Rgb8>> picture;  ///< with the settings as they are
  std::vector<NeedsStep> trail;
  /// False if the settings as they are differ from the reference by more than the tolerance: then the advice keeps to
  /// it, and may cost more than they do.
  bool within_tolerance = true;
};

/// What the scene needs of `base`. The reference is the picture that reference_settings() asks for (study/reference.h):
/// the ray tracer in double with its robust tests, traced shadows and at least 12 bounces, with as many samples of a
/// pixel as `base` takes, since where samples lie is not a feature of the scene. Scenes that rays cannot show, and
/// outlines, whose lines round ties, are held to the rasterizer in double and to themselves. The search tries
/// every saving, takes the one after which the least work is left among those within the tolerance (at equal work a
/// feature less, if the error grows no further for it), and goes on from there until none is left; it never adds work,
/// and changes the renderer only for half of it. It starts at `base`, or at the reference settings if `base` itself is
/// not within the tolerance. Throws Cancelled.
Needs find_needs(const NeedsRequest& request, StudyControl& control,
                 const std::function<void(const Needs&, const StudyStatus&)>& update = {});

}  // namespace ps
