#include "math/unit.h"
#include "study/stability/support.h"

namespace ps::stability::lookat_up_forward {
namespace {

/// The right vector of a camera at `eye` that looks at `target`, in float.
Vec3f right_of(const Vec3f& eye, const Vec3f& target, bool pick_another) {
  const Vec3f forward = unit_of(target - eye);
  Vec3f up(0, 1, 0);
  const Vec3f across = cross(up, forward);
  if (pick_another && dot(across, across) < 1e-6f) up = Vec3f(0, 0, 1);
  return unit_of(cross(up, forward));
}

std::vector<StabilityRow> measure(const StabilityRun& run) {
  Rows rows(run);
  for (const double angle : {1.0, 0.1, 1e-2, 2e-3, 1e-4, 1e-5, 1e-6, 1e-7, 0.0}) {
    run.check();
    Random random(run.seed);
    double naive = 0, robust = 0, nan = 0;
    const int cameras = run.count(20000, 2000);
    for (int i = 0; i < cameras; ++i) {
      const Vec3d eye(Vec3f(random.in_cube(5)));
      const double around = random.between(0, 2 * pi);
      const Vec3d forward(std::sin(angle) * std::cos(around), std::cos(angle), std::sin(angle) * std::sin(around));
      const Vec3d target = angle == 0 ? eye + Vec3d(0, 1, 0) : eye + forward;
      const auto degrees_off = [&](bool pick_another) {
        const Vec3d got(right_of(Vec3f(eye), Vec3f(target), pick_another));
        // Against the same choice made without rounding.
        const bool other = pick_another && std::sin(angle) < 1e-3;
        const Vec3d exact = unit_of(cross(other ? Vec3d(0, 0, 1) : Vec3d(0, 1, 0), forward));
        const Vec3d off = cross(got, exact);
        return std::atan2(std::sqrt(dot(off, off)), dot(got, exact)) * 180 / pi;
      };
      const double off = degrees_off(false), safe = degrees_off(true);
      if (std::isnan(off))
        ++nan;
      else
        naive += off * off;
      robust += safe * safe;
    }
    const double usable = cameras - nan;
    if (usable > 0)
      rows.push_back(
          {angle, "right vector", std::sqrt(naive / usable), std::sqrt(robust / cameras), "degrees off (rms)"});
    rows.push_back({angle, "no right vector", percent(nan, cameras), std::isnan(robust) ? 100.0 : 0.0, "% NaN"});
  }
  return rows;
}

}  // namespace

static constexpr StabilitySeries lookat_up_forward_series[]{
    {.names = "right vector", .title = "error of the right vector (RMS)", .unit = "degrees"},
    {.names = "no right vector", .title = "right vectors that are not numbers", .unit = "%"},
};

extern const StabilityExperiment lookat_up_forward{
    .key = "lookat-up-forward",
    .place = {Subject::shading, 70},
    .set_up = SetUp::reproduction,
    .title = "Look-at singularity: looking straight up",
    .keywords = "look-at, camera, gimbal lock, cross product, NaN",
    .knob = "angle between up and forward (radians)",
    .naive = "cross(up, forward)",
    .robust = "another up vector below 0.001 radians",
    .explanation = "The cross product of nearly parallel vectors is what is left of their rounding errors, and at 0 it "
                   "has no direction. A camera that passes the pole turns at random.",
    .safe = "From 0.001 radians on.",
    .window = {1e-3, everywhere},
    .series = lookat_up_forward_series,
    .measure = measure};

}  // namespace ps::stability::lookat_up_forward
