// Transforms and groups inside CSG (CGPP ex. 15.7b): parts that are stretched unequally, against quadrics and half
// spaces worked out in the world, in double precision.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "base/check.h"
#include "scene/rotation.h"
#include "scene/scene_file.h"
#include "scene/scene_writer.h"
#include "support/render_once.h"

namespace ps::csg_transform_test {
namespace {

constexpr int placed_side = 48;
constexpr const char* head = "viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n"
                             "light { type = ambient intensity = 1 }\n";

Scene scene_of(const std::string& text) { return parse_scene(head + text, "csg.scene", "."); }

Frame seen(const Scene& scene, Precision precision, Accelerator accelerator = Accelerator::none) {
  Settings settings;
  settings.accelerator = accelerator;
  settings.precision = precision;
  return render(scene, {scene.camera, placed_side, placed_side}, settings,
                request_for(Channel::depth | Channel::normal | Channel::ids));
}

/// Direction of the eye ray through a pixel's centre, with z = 1, so that t is the depth.
Vec3d eye_direction(int x, int y) { return {(x + 0.5) / placed_side - 0.5, 0.5 - (y + 0.5) / placed_side, 1}; }

struct Meeting {
  double t;
  Vec3d normal;
};

/// The first meeting with the quadric |A^-1 (p - centre)| = 1.
std::optional<Meeting> meet_ellipsoid(const Mat3d& a, const Vec3d& centre, const Vec3d& direction) {
  const Mat3d back = glm::inverse(a);
  const Vec3d o = back * -centre, d = back * direction;
  const double aa = dot(d, d), b = dot(o, d), c = dot(o, o) - 1;
  const double discriminant = b * b - aa * c;
  if (discriminant < 0) return {};
  const double t = (-b - std::sqrt(discriminant)) / aa;
  return Meeting{t, glm::normalize(glm::transpose(back) * (o + d * t))};
}

TEST(CsgTransform, AStretchedBallIsAnEllipsoid) {
  const std::string ball = "sphere { center = (0.5, 0, 0) radius = 0.5 color = red\n"
                           "  transform { scale = (2, 0.6, 1) rotation = <30 degrees around the Z axis>,"
                           " <40 degrees around the Y axis> translation = (0.1, -0.2, 4) } }";
  const Mat3d stretch(Vec3d(2, 0, 0), Vec3d(0, 0.6, 0), Vec3d(0, 0, 1));
  const Mat3d linear = rotation_about(Axis::y, 40) * rotation_about(Axis::z, 30) * stretch;
  const Vec3d centre = linear * Vec3d(0.5, 0, 0) + Vec3d(0.1, -0.2, 4);
  const Scene scene = scene_of("union { " + ball + " sphere { center = (0, 0, -9) radius = 1 } }");
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    const Frame frame = seen(scene, precision);
    const double tolerance = precision == Precision::float64 ? 1e-7 : 2e-4;  // channels are floats
    int hits = 0;
    for (int y = 0; y < placed_side; ++y)
      for (int x = 0; x < placed_side; ++x) {
        const auto expected = meet_ellipsoid(linear * 0.5, centre, eye_direction(x, y));
        ASSERT_EQ(frame.ids.at(x, y).object >= 0, expected.has_value()) << x << ", " << y;
        if (!expected) continue;
        ++hits;
        EXPECT_NEAR(frame.depth.at(x, y), expected->t, 4 * std::max(tolerance, 5e-7)) << x << ", " << y;
        EXPECT_LT(glm::length(Vec3d(frame.normal.at(x, y)) - expected->normal), std::max(tolerance * 20, 1e-6))
            << x << ", " << y;
      }
    EXPECT_GT(hits, 80);
  }
}

// Boxes around the whole, the parts' own maps included, keep no ray away.
TEST(CsgTransform, AcceleratorsHoldAllOfAPlacedPart) {
  const Scene scene = scene_of(
      "union { sphere { center = (0, 5, 9) radius = 0.2 transform { scale = (6, 1, 1) translation = (0, -4.7, -5) } }\n"
      "  sphere { center = (0, 5, 9) radius = 0.2 transform { translation = (0, -6, -5) } } }\n"
      "triangle { vertices = [(-9, -9, 9), (-9, -8, 9), (-8, -9, 9)] color = white }");
  const Frame all = seen(scene, Precision::float64);
  int hits = 0;
  for (const PixelId& id : all.ids.pixels()) hits += id.object == 0;
  EXPECT_GT(hits, 50);
  for (const Accelerator accelerator :
       {Accelerator::bvh, Accelerator::box, Accelerator::bounding_spheres, Accelerator::octree, Accelerator::two_level})
    EXPECT_TRUE(seen(scene, Precision::float64, accelerator).ids == all.ids) << static_cast<int>(accelerator);
}

// A sheared box with a bore, made by nested groups, against the half spaces of its six faces in the world.
TEST(CsgTransform, NestedGroupsMultiplyAndCutFacesHaveTheirNormals) {
  const std::string inner = "group { transform { rotation = <45 degrees around the Z axis> } "
                            "box { center = (0, 0, 0) size = (1, 1, 1) color = blue } }";
  const Scene boxes = scene_of("intersection { group { transform { scale = (2, 1, 1) translation = (0, 0.1, 4) } " +
                               inner + " } sphere { center = (0, 0, 4) radius = 9 } }");
  const Mat3d linear = Mat3d(Vec3d(2, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)) * rotation_about(Axis::z, 45);
  const Vec3d centre{0, 0.1, 4};
  std::string planes;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-0.5, 0.5}) {
      Vec3d normal(0);
      normal[axis] = sign;
      const Vec3d point = linear * normal + centre;
      normal = glm::transpose(glm::inverse(linear)) * normal;
      planes += "plane { point = (" + std::to_string(point.x) + ", " + std::to_string(point.y) + ", " +
                std::to_string(point.z) + ") normal = (" + std::to_string(normal.x) + ", " + std::to_string(normal.y) +
                ", " + std::to_string(normal.z) + ") color = blue }\n";
    }
  const Frame got = seen(boxes, Precision::float64);
  const Frame want = seen(scene_of("intersection { " + planes + "}"), Precision::float64);
  int hits = 0, differ = 0;
  for (int y = 0; y < placed_side; ++y)
    for (int x = 0; x < placed_side; ++x) {
      const bool hit = got.ids.at(x, y).object >= 0;
      hits += hit;
      differ += hit != (want.ids.at(x, y).object >= 0);
      if (!hit || want.ids.at(x, y).object < 0) continue;
      EXPECT_NEAR(got.depth.at(x, y), want.depth.at(x, y), 1e-5) << x << ", " << y;
      EXPECT_LT(glm::length(got.normal.at(x, y) - want.normal.at(x, y)), 1e-5f) << x << ", " << y;
    }
  EXPECT_GT(hits, 100);
  EXPECT_EQ(differ, 0);
}

// A mirrored, stretched cylinder taken out of a ball: the cut's normals point into the hole.
TEST(CsgTransform, ASubtractedPartIsTurned) {
  const Scene scene = scene_of("difference { sphere { center = (0, 0, 4) radius = 1 color = red }\n"
                               "  cylinder { from = (0, 0, -1) to = (0, 0, 1) radius = 0.3 color = green\n"
                               "    transform { scale = (-2, 1, 1) translation = (0, 0, 3) } } }");
  const Frame frame = seen(scene, Precision::float64);
  const int y = placed_side / 2, x = placed_side / 2;
  // The bottom of the bore is its cap at z = 4, which faces the camera.
  EXPECT_EQ(frame.ids.at(x, y).triangle, 1);
  EXPECT_NEAR(frame.depth.at(x, y), 4, 1e-6);
  EXPECT_LT(glm::length(frame.normal.at(x, y) - Vec3f(0, 0, -1)), 1e-6f);
  // Its side is an elliptic cylinder (x / 0.6)^2 + (y / 0.3)^2 = 1 whose normals, turned, point to the axis.
  int sides = 0;
  for (int row = 0; row < placed_side; ++row)
    for (int column = 0; column < placed_side; ++column) {
      if (frame.ids.at(column, row).triangle != 1 || std::abs(frame.normal.at(column, row).z) > 0.5f) continue;
      const Vec3d p = eye_direction(column, row) * static_cast<double>(frame.depth.at(column, row));
      EXPECT_NEAR(p.x * p.x / 0.36 + p.y * p.y / 0.09, 1, 1e-5);
      const Vec3d expected = -glm::normalize(Vec3d(p.x / 0.36, p.y / 0.09, 0));
      EXPECT_LT(glm::length(Vec3d(frame.normal.at(column, row)) - expected), 1e-5);
      ++sides;
    }
  EXPECT_GT(sides, 5);
}

TEST(CsgTransform, OperationsLieInGroupsOfModels) {
  const std::string parts = "sphere { center = (0, 0, 0) radius = 1 color = red } "
                            "sphere { center = (0, 0, -1) radius = 0.5 color = blue } }";
  const Frame a =
      seen(scene_of("group { transform { scale = (1, 0.5, 1) translation = (0, 0, 4) } difference { " + parts + "}"),
           Precision::float64);
  const Frame b = seen(scene_of("difference { transform { scale = (1, 0.5, 1) translation = (0, 0, 4) } " + parts),
                       Precision::float64);
  EXPECT_TRUE(a.depth == b.depth);
  EXPECT_NEAR(a.depth.at(placed_side / 2, placed_side / 2), 3.5, 1e-2) << "the bottom of the dent";
}

TEST(CsgTransform, IsWrittenAndReadAgain) {
  const Scene scene =
      scene_of("difference { name = d  box { center = (0, 0, 4) size = 2 color = red }\n"
               "  group { transform { scale = (1, 2, 3) } intersection {\n"
               "    sphere { center = (0, 0, 1) radius = 1 transform { rotation = <20 degrees around the X axis> } }\n"
               "    box { center = (0, 0, 1) size = 1.5 } } } }");
  const Scene again = parse_scene(write_scene(scene, "."), "again.scene", ".");
  EXPECT_TRUE(seen(again, Precision::float64).depth == seen(scene, Precision::float64).depth);
}

TEST(CsgTransform, ErrorsNameTheBlockAtFault) {
  const auto error = [](const std::string& text) {
    try {
      parse_scene(text, "e.scene", ".");
    } catch (const InputError& thrown) {
      return std::string(thrown.what());
    }
    return std::string("no error");
  };
  const std::string ball = "sphere { center = (0, 0, 0) radius = 1 } ";
  EXPECT_EQ(error("difference {\n  group { } " + ball + "}").substr(0, 54),
            "e.scene:2:3: found 'group' with 0 parts, expected one ");
  EXPECT_EQ(error("union { " + ball + "}").substr(0, 50), "e.scene:1:1: found 'union' with 1 parts, expected ");
  EXPECT_EQ(
      error("union { " + ball + ball + "\ninstance { model = x } }"),
      "e.scene:2:1: found an instance inside 'union', expected a solid body: a model of triangles may have no inside");
  EXPECT_NE(error("group {\nplane { point = (0, 0, 0) normal = (0, 1, 0) } }")
                .find("e.scene:2:1: found 'plane' inside 'group'"),
            std::string::npos);
  EXPECT_NE(
      error("union { " + ball + "group {\n transform { rotation = [(1, 0, 0), (2, 0, 0), (0, 0, 1)] } " + ball + "} }")
          .find("too large, too small or flat"),
      std::string::npos);
}

}  // namespace
}  // namespace ps::csg_transform_test
