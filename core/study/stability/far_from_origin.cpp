#include <array>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "raster/assembly/vertex_stage.h"
#include "scene/scene_file.h"
#include "study/stability/support.h"

namespace ps::stability::far_from_origin {
namespace {

constexpr double eye_distance = 4;  ///< from the ball's centre, world units

/// A ball of radius 1 whose centre lies `distance` from the origin along every axis, before the book's camera.
std::string ball_text(double distance) {
  return fmt::format("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = white\n"
                     "model {{ name = ball sphere_divisions = 24 color = (70, 130, 190) }}\n"
                     "instance {{ model = ball position = ({0}, {0}, {0}) }}\n"
                     "camera {{ position = ({0}, {0}, {1}) }}\n"
                     "light {{ type = ambient intensity = 0.2 }}\n"
                     "light {{ type = directional intensity = 0.8 direction = (-1, 2, -2) }}\n",
                     distance, distance - eye_distance);
}

/// Distance of vertices from their true places on the canvas, px.
class Error {
 public:
  void add(double off) {
    squares_ += off * off;
    largest_ = std::max(largest_, off);
    ++count_;
  }
  double rms() const { return std::sqrt(squares_ / count_); }
  double largest() const { return largest_; }

 private:
  double squares_ = 0, largest_ = 0, count_ = 0;
};

/// World to camera space as most programs compute it: one 4 x 4 matrix in float (here without its last row) times a
/// world position in float. Pixelscope has no such option; it is here because it is the usual way.
class FloatMatrix {
 public:
  explicit FloatMatrix(const Camera& camera)
      : rows_{Vec3f(camera.right), Vec3f(camera.up), Vec3f(camera.forward)},
        move_(Vec3d(-dot(camera.right, camera.position), -dot(camera.up, camera.position),
                    -dot(camera.forward, camera.position))) {}
  Vec3f operator()(const Vec3d& world) const {
    const Vec3f p(world);
    return {dot(rows_[0], p) + move_.x, dot(rows_[1], p) + move_.y, dot(rows_[2], p) + move_.z};
  }

 private:
  std::array<Vec3f, 3> rows_;
  Vec3f move_;
};

struct Errors {
  Error relative, rounded_first, matrix;
};

/// The ball seen by cameras that are around it and look at its centre. The truth is computed from the ball's own
/// coordinates, which no distance makes larger.
Errors errors_at(double distance, const StabilityRun& run) {
  run.check();
  Scene scene = parse_scene(ball_text(distance), "ball", ".");
  const Vec3d centre(distance);
  Random random(run.seed);
  Prepared prepared;
  Progress progress;
  Errors errors;
  for (int i = run.count(200, 40); i > 0; --i) {
    Camera& camera = scene.camera;
    camera.forward = random.direction();
    camera.right = glm::normalize(cross(Vec3d(0, 1, 0), camera.forward));
    camera.up = cross(camera.forward, camera.right);
    camera.position = centre - camera.forward * eye_distance;
    const FloatMatrix matrix(camera);
    Settings settings;
    settings.renderer = renderer_for(PictureWay::fragments);
    for (const bool camera_relative : {true, false}) {
      settings.camera_relative = camera_relative;
      const auto inputs =
          raster::make_raster_inputs<float>(scene, {camera, 600, 600}, settings, Channel::none, prepared);
      const auto vertices = raster::run_vertex_stage(inputs, std::vector<bool>(inputs.objects.size(), false),
                                                     raster::VertexUse::picture, ParallelOptions{1}, progress);
      const auto exact = raster::make_canvas_projection<double>(inputs.viewport);
      for (std::size_t v = 0; v < vertices[0].camera.size(); ++v) {
        const Vec3d own = inputs.objects[0].mesh->positions[v];
        const Vec3d truth(dot(camera.right, own), dot(camera.up, own), dot(camera.forward, own) + eye_distance);
        const Vec2d place = exact.from_top_left(truth);
        const auto off = [&](const Vec3f& point) {
          return glm::length(Vec2d(inputs.projection.from_top_left(point)) - place);
        };
        (camera_relative ? errors.relative : errors.rounded_first).add(off(Vec3f(vertices[0].camera[v])));
        if (!camera_relative) errors.matrix.add(off(matrix(centre + own)));
      }
    }
  }
  return errors;
}

void measure(const StabilityRun& run, Rows& rows) {
  for (const double distance : {0.0, 1e3, 1e4, 1e5, 1e6, 1e7}) {
    const Errors errors = errors_at(distance, run);
    const auto add = [&](const std::string& name, const Error& naive) {
      rows.add(distance, name + ", rms", naive.rms(), errors.relative.rms(), "px");
      rows.add(distance, name + ", largest", naive.largest(), errors.relative.largest(), "px");
    };
    add("camera-relative = off", errors.rounded_first);
    add("4 x 4 matrix in float", errors.matrix);
  }
}

StabilityPicture picture(double distance) {
  StabilityPicture picture{.scene = ball_text(distance)};
  picture.robust.renderer = renderer_for(PictureWay::fragments);
  picture.naive = picture.robust;
  picture.naive.camera_relative = false;
  return picture;
}

}  // namespace

extern const StabilityExperiment far_from_origin{
    .key = "far-from-origin",
    .place = {Subject::shading, 60},
    .title = "Far from the origin",
    .keywords = "floating origin, large world, jitter, float precision",
    .knob = "distance of the scene from the origin, along each axis (world units)",
    .naive = "round world positions to float, then subtract the camera's position",
    .robust = "subtract the camera's position in double, then round (camera-relative = on)",
    .explanation = "At 1,000,000 units neighbouring floats are 1/16 apart, so vertices jump by up to half of that. The "
                   "difference between vertex and camera is small and fits a float well.",
    .safe = "Up to 10,000 units: a vertex is off by a quarter of a pixel at most.",
    .window = {nowhere, 1e4},
    .series = {{.names = "camera-relative = off, rms|*", .title = "error of projected vertices (RMS)", .unit = "px"},
               {.names = "*largest", .title = "largest error of projected vertices", .unit = "px"}},
    .add_rows = measure,
    .picture = picture,
    .frames = {1e4, 1e5, 1e6, 1e7}};

}  // namespace ps::stability::far_from_origin
