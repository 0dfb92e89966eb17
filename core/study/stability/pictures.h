#pragma once
#include <optional>

#include "frame/view.h"
#include "scene/scene.h"
#include "study/stability/experiment.h"

namespace ps {

/// A point of an experiment made ready for A and B.
struct StabilityOpening {
  std::string scene_name;  ///< of a built-in scene, or the experiment's key for a scene of its own
  std::string scene_text;  ///< of a scene of its own; empty for a built-in one
  Scene scene;
  View view;
  Settings naive, robust;  ///< for A and for B
  std::optional<Vec2i>
      failing;                 ///< array position of a pixel that fails, in the middle of others; none where all agree
  double failing_percent = 0;  ///< of pixels that differ by more than 8 levels
};

/// nullopt if the experiment has no picture. Renders both pictures once to find the failing pixel. Throws Cancelled.
std::optional<StabilityOpening> open_stability_point(const StabilityExperiment& experiment, double knob,
                                                     Progress& progress);

struct FilmStripOptions {
  int frame_height = 160;  ///< pixels; frames keep the shape of their picture
  int gap = 4;             ///< between frames, filled with white
};

/// Pictures over the knob: the naive method in the upper row, the robust one below it, and in the third row white where
/// they differ by more than 8 levels, over a darkened copy of the naive one. nullopt without a picture. Throws
/// Cancelled.
std::optional<Image<Rgb8>> film_strip(const StabilityExperiment& experiment, const FilmStripOptions& options,
                                      Progress& progress);

}  // namespace ps
