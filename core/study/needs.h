#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/render.h"
#include "scene/mesh_bytes.h"
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
  bool absent = false;               ///< the scene cannot use it with any settings
  std::optional<IdleReason> reason;  ///< why it is free to drop, if it is not used
  double error_without = 0;          ///< worst_tile_flip against the truth when it is switched off
  double increase = 0;               ///< worst_increase() over the settings as they are: what switching it off costs
  double cost_share = 0;             ///< share of the time of a picture that it takes
  bool cost_differs = false;         ///< both times are not within_noise() of each other
  double work_share = 0;             ///< the same of the counted work
  std::shared_ptr<const Image<Rgb8>> picture;  ///< without it; null if it is not used
};

/// Is the feature needed, by the one measure of sentence and advice?
inline bool is_needed(const FeatureShare& share, double tolerance) { return share.used && share.increase > tolerance; }

/// One step of the search.
struct NeedsStep {
  std::string change;   ///< "shadows=none"
  double error = 0;     ///< worst_tile_flip against the truth
  double increase = 0;  ///< worst_increase() over the picture from which the search started
  std::uint64_t work = 0;
  bool accepted = false;
};

struct Needs {
  double tolerance = 0;
  Settings advice;
  std::string truth;                    ///< ReferencePlan::description()
  double uncertainty = 0;               ///< reference_noise() of the truth: mean FLIP between halves of its samples
  double error = 0, default_error = 0;  ///< worst_tile_flip against the truth
  double increase = 0;                  ///< of the advice, as in NeedsStep
  double time_ms = 0, default_time_ms = 0;
  bool time_differs = false;  ///< both times are not within_noise() of each other
  MeshBytes meshes;           ///< of the scene
  std::string machinery;      ///< which code was timed, the same for all: TimedSettings::reason
  std::uint64_t work = 0, default_work = 0;
  std::vector<FeatureShare> shares;
  std::shared_ptr<const Image<Rgb8>> picture;  ///< with the settings as they are
  std::vector<NeedsStep> trail;
  /// False if exact settings come closer to the truth by more than the tolerance in some tile, and lose as much in
  /// none: then the search starts from those, and the advice may cost more than the settings as they are.
  bool within_tolerance = true;
};

/// The least share of the work that a saving must save: less is lost in the noise of times.
inline constexpr double least_saving = 0.05;

/// What the scene needs of `base`, against needs_truth(). A picture without a feature counts by how much it is further
/// from the truth than that of `base`, tile by tile: what one sample for each pixel misses at edges is the same in
/// both. The search tries every saving, takes the one after which the least work is left among those within the
/// tolerance, and goes on from there until none is left. It takes no saving below least_saving, but for a feature whose
/// loss changes no tile for the worse, and for what is more exact than in `base`; it never adds work, changes the
/// renderer only for half of it, and switches off no feature that is_needed(). Throws Cancelled.
Needs find_needs(const NeedsRequest& request, StudyControl& control,
                 const std::function<void(const Needs&, const StudyStatus&)>& update = {});

}  // namespace ps
