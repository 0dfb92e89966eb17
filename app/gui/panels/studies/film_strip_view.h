#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "gui/platform/texture.h"
#include "gui/work/background_study.h"
#include "study/plot_frame.h"
#include "study/stability/pictures.h"

namespace ps::gui {

/// The film strip of one experiment.
struct FilmStrip {
  std::string key;  ///< of the experiment
  Image<Rgb8> picture;
};

/// Film strips as they come, one experiment after the other.
struct FilmStripState {
  explicit FilmStripState(const std::function<void()>& wake) : study(wake) {}
  std::string wanted;                      ///< key of the experiment whose strip is being made
  std::shared_ptr<const FilmStrip> shown;  ///< what the texture was made from
  Texture texture;
  std::string chosen_of;         ///< key of the experiment that `chosen` belongs to
  std::optional<double> chosen;  ///< the knob whose frame is marked, and shown in A and B
  BackgroundStudy<FilmStrip> study;
};

/// The width of the slider, at scale 1.
inline constexpr double film_slider_width = 270;
/// A slider over the strip's frames, in the order of their knobs. Answers the knob that it was moved to.
std::optional<double> film_strip_slider(FilmStripState& state, const StabilityExperiment& experiment);

/// The strip of the experiment over the whole width: above each frame its knob, with a line from there to the knob's
/// place on the axis of the plot `above`, if there is one over the same knob. Answers the knob of the frame that was
/// newly chosen, by a click or by a drag along the strip. Empty for an experiment without pictures.
std::optional<double> film_strip_view(FilmStripState& state, const StabilityExperiment& experiment,
                                      const PlotFrame* above);

}  // namespace ps::gui
