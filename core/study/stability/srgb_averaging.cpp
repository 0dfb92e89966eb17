#include <cmath>

#include "study/stability/support.h"

namespace ps::stability::srgb_averaging {
namespace {

/// Linear light as an sRGB level (IEC 61966-2-1).
double level_of(double linear) {
  const double value = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return 255 * value;
}

/// The light of an sRGB level.
double light_of(double level) {
  const double value = level / 255;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// A pixel of 100 samples, `white` of them white and the others black: the level of each kind of mean.
struct Means {
  double of_levels = 0, of_light = 0;
};
Means means(int white) {
  constexpr int samples = 100;
  double levels = 0, light = 0;
  for (int i = 0; i < samples; ++i) {
    const double level = i < white ? 255 : 0;
    levels += level;
    light += light_of(level);
  }
  return {levels / samples, level_of(light / samples)};
}

}  // namespace

/// A pixel of which white covers a share and black the rest: both means against the level of that share of the light.
static void measure_srgb_averaging(const StabilityRun& run, Rows& rows) {
  run.check();
  for (const int white : {1, 5, 10, 24, 25, 50, 75, 90, 99}) {
    const double right = level_of(white / 100.0), knob = white;
    const Means mean = means(white);
    rows.add(knob, "white over black", std::abs(mean.of_levels - right), std::abs(mean.of_light - right),
             "levels of 255");
    rows.add(knob, "white over black, level shown", std::round(mean.of_levels), std::round(mean.of_light),
             "level of 255");
  }
}

extern const StabilityExperiment srgb_averaging{
    .key = "srgb-averaging",
    .place = {Subject::numbers, 10},
    .set_up = SetUp::reproduction,
    .title = "Gamma-incorrect averaging: means of sRGB levels",
    .keywords = "gamma, gamma-incorrect averaging, linear light, blending, resize",
    .knob = "share of white (%)",
    .naive = "mean of the levels",
    .robust = "level of the mean light",
    .explanation = "sRGB levels are not proportional to light. The mean of two levels is darker than the mean of their "
                   "light, so filtered edges become too dark.",
    .safe = "Between equal levels only.",
    .window = nowhere_safe,
    .series = {{.names = "white over black", .title = "error of the level", .unit = "levels of 255"},
               {.names = "white over black, level shown",
                .title = "level that is shown",
                .unit = "level of 255",
                .better = Better::neither}},
    .add_rows = measure_srgb_averaging};

}  // namespace ps::stability::srgb_averaging
