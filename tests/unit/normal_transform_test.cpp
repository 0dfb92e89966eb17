// Normals of a ball scaled by unequal factors, against the normals of the ellipsoid that it becomes.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/load.h"
#include "scene/world.h"
#include "support/render_once.h"

namespace ps::normal_transform_test {
namespace {

/// The largest angle (degrees) between a transformed normal and that of x^2 / s^2 + y^2 + z^2 = 1.
double largest_angle(double s, NormalTransform how) {
  Transform transform;
  transform.scale = {s, 1, 1};
  const Mat3d matrix = normal_matrix(transform, how);
  double largest = 0;
  for (int i = 0; i <= 3600; ++i) {
    const double angle = i * std::numbers::pi / 3600;
    const Vec3d on_ball{std::cos(angle), std::sin(angle), 0};
    const Vec3d normal = normal_to_world(matrix, on_ball);
    const Vec3d p = to_world(transform, on_ball);
    const Vec3d true_normal{p.x / (s * s), p.y, p.z};  // the gradient
    const double cosine = dot(normal, true_normal) / std::sqrt(dot(true_normal, true_normal));
    largest = std::max(largest, std::acos(std::min(cosine, 1.0)) * 180 / std::numbers::pi);
  }
  return largest;
}

// The model matrix turns normals the wrong way: off by up to 2 atan(s) - 90 degrees, 36.87 for a factor of 2.
TEST(NormalTransform, InverseTransposeIsRightWhereTheModelMatrixIsNot) {
  for (const double s : {1.0, 2.0, 5.0, 100.0}) {
    const double expected = 2 * std::atan(s) * 180 / std::numbers::pi - 90;
    EXPECT_NEAR(largest_angle(s, NormalTransform::model), expected, 0.05) << s;
    EXPECT_LT(largest_angle(s, NormalTransform::inverse_transpose), 1e-5) << s;
  }
  EXPECT_NEAR(largest_angle(2, NormalTransform::model), 36.87, 0.01);
}

// In the picture: the model matrix lights the flattened balls wrongly; the third, scaled alike on all axes, is the
// same.
TEST(NormalTransform, ShowsOnlyOnBallsThatAreNotScaledAlike) {
  const Scene scene = load_scene("lab/flattened");
  Settings settings{.renderer = Renderer::rasterizer};
  RenderRequest request;
  request.channels = Channel::ids;
  const View view{scene.camera, 200, 200};
  const Frame right = render(scene, view, settings, request);
  settings.normal_transform = NormalTransform::model;
  const Frame wrong = render(scene, view, settings, request);
  std::array<double, 3> largest{};
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) {
      const int object = right.ids.at(x, y).object;
      if (object < 0) continue;
      const Vec3f d = right.colour.at(x, y) - wrong.colour.at(x, y);
      auto& most = largest[static_cast<std::size_t>(object)];
      most = std::max(most, 255.0 * std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}));
    }
  EXPECT_GT(largest[0], 40);
  EXPECT_GT(largest[1], 40);
  EXPECT_LT(largest[2], 0.01);
}

}  // namespace
}  // namespace ps::normal_transform_test
