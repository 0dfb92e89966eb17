#pragma once
#include <algorithm>
#include <compare>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "options/settings.h"
#include "study/control.h"
#include "study/stability/series.h"

namespace ps {
namespace stability {
class Rows;
}

/// One measured place of a curve. A method that a series does not have is NaN: a series of one method, a closed form or
/// a ratio has its value in `naive` or in `robust` alone.
struct StabilityRow {
  double knob = 0;
  std::string series;
  double naive = std::numeric_limits<double>::quiet_NaN();
  double robust = std::numeric_limits<double>::quiet_NaN();
  std::string unit;
};

/// What an experiment may use: random numbers come from the seed alone, so a run can be repeated.
struct StabilityRun {
  std::uint32_t seed = 1;
  Progress* progress = nullptr;                        ///< asked between knobs; may stop the experiment with Cancelled
  double effort = 1;                                   ///< share of the full number of rays, triangles or pixels
  StudyControl* control = nullptr;                     ///< asked as well; the experiment waits while it is paused
  std::function<void(const StabilityRow&)> arrived{};  ///< called with each row when it is measured
  void check() const {
    if (control) control->wait_here();
    if (progress) progress->check();
  }
  /// The number of trials: a share of `full`, at least `least`.
  int count(int full, int least = 1) const { return std::max(least, static_cast<int>(full * effort)); }
  /// Side of a picture of `full` x `full` pixels, the same parity kept.
  int side(int full, int least = 64) const {
    if (effort >= 1) return full;
    const int reduced = std::max(least, full / 4);
    return reduced + (reduced + full) % 2;
  }
};

/// Where on the knob the naive method may be used: low <= knob <= high.
struct SafeWindow {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool empty() const { return !(low <= high); }
  bool holds(double knob) const { return low <= knob && knob <= high; }
};

/// What shows a knob as a picture: the naive settings belong into A, the robust ones into B.
struct StabilityPicture {
  std::string scene;  ///< a built-in scene's name, or a scene's text if it has more than one line
  int width = 200, height = 200;
  Settings naive{}, robust{};
};

/// Where the set-up of an experiment comes from.
enum class SetUp {
  illustration,  ///< it is our own
  reproduction   ///< another measurement describes it completely, at least for some of the series
};
/// A sentence for those who read the results; empty: none is needed.
std::string_view set_up_text(SetUp set_up);

/// What an experiment is about; the experiments are listed in this order.
enum class Subject { rays, boxes, coverage, depth, shadows, shading, sampling, numbers };

/// Where an experiment is in the list. No two have the same place; ranks leave room between neighbours.
struct Place {
  Subject subject = Subject::numbers;
  int rank = 0;
  auto operator<=>(const Place&) const = default;  // NOLINT(modernize-use-nullptr): a < b compares it with 0
};

/// A place where a method fails, with what does not fail there.
struct StabilityExperiment {
  std::string_view key;  ///< "ground-sphere-acne"
  Place place;
  SetUp set_up = SetUp::illustration;
  std::string_view title;
  std::string_view keywords{};          ///< other words that people search for, separated by commas
  std::string_view knob;                ///< what is turned, with its unit
  std::string_view naive, robust;       ///< the two methods
  std::string_view explanation;         ///< why, in two sentences
  std::string_view safe;                ///< where the naive method may be used, in words
  SafeWindow window;                    ///< the same on the knob
  std::vector<StabilitySeries> series;  ///< what its series measure; the one first that the text speaks of
  void (*add_rows)(const StabilityRun&, stability::Rows&) = nullptr;  ///< measures
  StabilityPicture (*picture)(double knob) = nullptr;                 ///< null: nothing to see
  bool measures_driver = false;  ///< it needs the renderer that uses a graphics driver (render/renderer_table.h)
  std::vector<double> frames{};  ///< knobs of the film strip, from left to right: those of the first of `series`

  /// Its table.
  std::vector<StabilityRow> measure(const StabilityRun& run) const;
};

/// All experiments of this program, by their place; those that measure the graphics driver are not among them where no
/// renderer uses it. Adding one is a file with its constant: cmake/Experiments.cmake finds those.
std::span<const StabilityExperiment> stability_experiments();
/// Throws InputError naming the nearest key, or what an experiment needs that this program was built without.
const StabilityExperiment& find_stability_experiment(std::string_view key);
/// Why this machine cannot measure the experiment ("no OpenGL: no driver ..."), or nothing: it can.
std::optional<std::string> why_not_measured(const StabilityExperiment& experiment);
/// Whether an experiment is found by what a person types: every word must occur in its key, title, keywords,
/// explanation or methods.
bool experiment_matches(const StabilityExperiment& experiment, std::string_view wanted);

/// The table "knob,series,naive,robust,unit"; a method that does not exist is an empty field.
std::string stability_csv(std::span<const StabilityRow> rows);

}  // namespace ps
