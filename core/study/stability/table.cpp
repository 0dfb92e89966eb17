#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/check.h"
#include "study/stability/experiments.h"

namespace ps {
namespace {

using namespace stability;

constexpr std::array<StabilityExperiment, 11> table{{
    {"ground-sphere-acne", "Ground-sphere acne", "shadow epsilon (ray parameter)", "ignore hits up to epsilon",
     "bounded offset, no epsilon",
     "At radius 5000 the squared distance to the centre lies on a grid of 2, so hit points sit up to 0.00018 off the "
     "sphere. A shadow ray that starts below the surface meets it again, later the lower the light stands.",
     "No epsilon is safe for every radius and light; 0.001 serves the book's scene.", ground_sphere_acne},
    {"reflection-self-hit", "Reflection self-hit", "reflection epsilon (ray parameter)", "ignore hits up to epsilon",
     "bounded offset, no epsilon",
     "Towards the horizon mirrored rays leave the ground almost along it and stay within its rounding error for long. "
     "The book's 0.001 is enough in double and not in float.",
     "0.1 in float; 0.001 in double.", reflection_self_hit},
    {"ray-sphere-cancellation", "Ray and sphere: cancellation", "distance / radius", "b^2 - 4ac", "remainder vector",
     "The relative error of c grows with the square of distance over radius and reaches 1 at 4096 in float. The "
     "remainder vector compares lengths of the size of the radius and loses nothing.",
     "Up to 100 radii.", ray_sphere_cancellation},
    {"interpolate-drift", "Interpolate drifts", "steps", "d += slope", "each value from the ends",
     "Every addition rounds, and a constant slope rounds the same way each time. A value computed from the ends has "
     "one rounding only.",
     "Up to about 10,000 steps for a third of a pixel.", interpolate_drift},
    {"z-vs-1-z", "z against 1/z", "ratio of the depths of the ends", "mix z", "mix 1/z",
     "Equal steps on the screen are not equal steps in depth. 1/z is linear on the screen, z is not.",
     "Ratios up to 1.1 for an error of 2.5 %.", inverse_depth},
    {"normal-under-scale", "Normals under a scale", "scale along one axis", "transform like positions",
     "inverse transpose",
     "A plane that is stretched tilts one way and its normal, stretched with it, the other. The inverse transpose "
     "keeps "
     "normal and plane perpendicular.",
     "Uniform scales only.", normal_under_scale},
    {"recursion-depth", "Recursion depth", "bounces", "stop after so many", "8 bounces",
     "What is cut off weighs the product of the reflectivities along the path. Half-mirrors need 8 bounces to fall "
     "below half a level.",
     "From 5 bounces for this scene.", recursion_depth},
    {"srgb-averaging", "Averages of stored levels", "share of white (%)", "mean of levels", "mean of light",
     "Stored levels are not proportional to light. Their mean makes edges too dark.",
     "Nowhere between black and white.", srgb_averaging},
    {"sample-accumulation", "Sums of many samples", "samples", "float sum", "Kahan's sum",
     "A float sum of size S adds multiples of its own spacing only. From 16,777,216 on it no longer counts by ones.",
     "Up to a million samples for 1e-5.", sample_accumulation},
    {"refraction-total-internal", "Total internal reflection", "index of refraction", "Snell's law alone",
     "reflect beyond the critical angle",
     "Beyond the critical angle the sine of the refracted ray would exceed 1. Its cosine is then the root of a "
     "negative "
     "number.",
     "Index 1.", refraction_total_internal},
    {"acos-of-unit-dot", "acos of a unit vector's square", "length", "acos(dot)", "clamp to [-1, 1] first",
     "Normalising rounds, so that many unit vectors are a little too long. acos of more than 1 is not a number.",
     "Nowhere in float.", acos_of_unit_dot},
}};

std::string number_field(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

}  // namespace

std::span<const StabilityExperiment> stability_experiments() { return table; }

const StabilityExperiment& find_stability_experiment(std::string_view key) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const auto& row) { return row.key == key; });
  if (found != table.end()) return *found;
  std::string known;
  for (const StabilityExperiment& row : table) known += fmt::format(" {}", row.key);
  throw InputError(fmt::format("stability: found '{}', expected one of{}", key, known));
}

std::string stability_csv(std::span<const StabilityRow> rows) {
  std::string text = "knob,series,naive,robust,unit\n";
  for (const StabilityRow& row : rows)
    text += fmt::format("{},\"{}\",{},{},\"{}\"\n", row.knob, row.series, number_field(row.naive),
                        number_field(row.robust), row.unit);
  return text;
}

}  // namespace ps
