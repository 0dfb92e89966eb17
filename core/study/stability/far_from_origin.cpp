#include <array>

#include <glm/geometric.hpp>

#include "study/stability/support.h"

namespace ps::stability {
namespace {

constexpr double focal = 600, middle = 300;  ///< pixels: a canvas of 600 x 600

struct Error {
  double rms = 0, largest = 0;  ///< px
};

/// How far from their true places on the canvas are points before a camera that stands W from the origin in every
/// direction and looks anywhere: positions and camera in float through one 4 x 4 matrix, or minus the camera in double
/// first. Points that float places behind the camera are not drawn, so they do not count.
Error error_at(double distance, bool relative, const StabilityRun& run) {
  run.check();
  Random random(run.seed);
  Error error;
  double drawn = 0;
  const int points = run.count(100000, 20000);
  for (int i = 0; i < points; ++i) {
    const Vec3d eye = Vec3d(1) * distance;
    const Vec3d forward = random.direction(), right = glm::normalize(cross(Vec3d(0, 1, 0), forward));
    const Vec3d up = cross(forward, right);
    const double z = random.between(0.65, 10), x = random.between(-0.5, 0.5) * z, y = random.between(-0.5, 0.5) * z;
    const Vec3d world = eye + right * x + up * y + forward * z;
    const auto project = [&](double cx, double cy, double cz) {
      return Vec2d(middle + focal * cx / cz, middle + focal * cy / cz);
    };
    const Vec3d from_eye = world - eye;
    const Vec2d truth = project(dot(right, from_eye), dot(up, from_eye), dot(forward, from_eye));
    const Vec3f r(right), u(up), f(forward);
    Vec3f camera;
    if (relative) {
      const Vec3f p(from_eye);
      camera = Vec3f(dot(r, p), dot(u, p), dot(f, p));
    } else {
      const Vec3f p(world), move(Vec3d(-dot(right, eye), -dot(up, eye), -dot(forward, eye)));
      camera = Vec3f(dot(r, p) + move.x, dot(u, p) + move.y, dot(f, p) + move.z);
    }
    const auto on_canvas = [&](float along) {
      const float normalised = static_cast<float>(focal / middle) * along / camera.z;  // -1 to 1
      return (normalised + 1) * static_cast<float>(middle);
    };
    const float px = on_canvas(camera.x), py = on_canvas(camera.y);
    const double off = std::hypot(static_cast<double>(px) - truth.x, static_cast<double>(py) - truth.y);
    if (!(camera.z > 0)) continue;
    ++drawn;
    error.rms += off * off;
    error.largest = std::max(error.largest, off);
  }
  error.rms = std::sqrt(error.rms / drawn);
  return error;
}

std::vector<StabilityRow> measure(const StabilityRun& run) {
  Rows rows(run);
  for (const double distance : {0.0, 1e3, 1e4, 1e5, 1e6, 1e7}) {
    const Error naive = error_at(distance, false, run), robust = error_at(distance, true, run);
    rows.push_back({distance, "rms", naive.rms, robust.rms, "px"});
    rows.push_back({distance, "largest", naive.largest, robust.largest, "px"});
  }
  return rows;
}

StabilityPicture picture(double) {
  StabilityPicture picture{.scene = "lab/far-origin"};
  picture.robust.renderer = Renderer::rasterizer;
  picture.naive = picture.robust;
  picture.naive.camera_relative = false;
  return picture;
}

constexpr std::array frames{1e6};

}  // namespace

const StabilityExperiment far_from_origin{
    .key = "far-from-origin",
    .title = "Far from the origin",
    .knob = "distance of the world from the origin",
    .naive = "one 4 x 4 matrix in float",
    .robust = "subtract the camera in double first",
    .explanation = "A million units away floats are 1/16 apart, so vertices and camera jump by as much against each "
                   "other. The difference of the two is small and fits a float well.",
    .safe = "Up to 10,000 units for a fifth of a pixel.",
    .window = {nowhere, 1e4},
    .measure = measure,
    .picture = picture,
    .frames = frames};

}  // namespace ps::stability
