// CSG against the definition: a point is in a union, an intersection, a difference or it is not.
#include "raytrace/clear/csg.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "raytrace/clear/self_hit.h"
#include "raytrace/clear/tracer.h"
#include "render/render.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/refusal.h"

namespace ps::csg_test {
namespace {

bool inside(const CsgNode& node, const Vec3d& p) {
  if (node.children.empty()) {
    if (const auto* ball = std::get_if<Ball>(&node.part.form)) return glm::length(p - ball->centre) < ball->radius;
    if (const auto* plane = std::get_if<Plane>(&node.part.form)) return dot(p - plane->point, plane->normal) < 0;
    const auto& brick = std::get<Brick>(node.part.form);
    const Vec3d d = glm::abs(p - brick.centre) * 2.0;
    return d.x < brick.size.x && d.y < brick.size.y && d.z < brick.size.z;
  }
  bool result = inside(node.children.front(), p);
  for (std::size_t i = 1; i < node.children.size(); ++i) {
    const bool child = inside(node.children[i], p);
    if (node.operation == CsgOperation::union_of) result = result || child;
    if (node.operation == CsgOperation::intersection) result = result && child;
    if (node.operation == CsgOperation::difference) result = result && !child;
  }
  return result;
}

class Trees {
 public:
  explicit Trees(unsigned seed) : random_(seed) {}
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  Vec3d vec(double reach) { return {number(-reach, reach), number(-reach, reach), number(-reach, reach)}; }
  CsgNode tree(int depth) {
    CsgNode node;
    if (depth == 0) {
      const int kind = below(5);
      if (kind < 2) node.part.form = Ball{vec(1), number(0.5, 1.5)};
      if (kind == 2 || kind == 3) node.part.form = Brick{vec(1), {number(0.5, 2), number(0.5, 2), 1}, Mat3d(1.0)};
      if (kind == 4) node.part.form = Plane{vec(1), vec(1)};
      return node;
    }
    node.operation = static_cast<CsgOperation>(below(3));
    for (int i = 0; i < 2 + below(2); ++i) node.children.push_back(tree(depth - 1));
    return node;
  }

 private:
  std::mt19937 random_;
};

Scene scene_of(const CsgNode& root) {
  Scene scene;
  Geometry geometry;
  geometry.objects.push_back({"csg", Csg{root}});
  scene.geometry = Part(std::move(geometry));
  scene.materials = Part(std::vector<Material>{Material{}});
  return scene;
}

/// Follows one line through the solid, surface by surface, and checks the stretches between against the definition,
/// and that each normal points out of the solid.
TEST(Csg, SurfacesBoundExactlyWhatTheDefinitionSays) {
  constexpr unsigned seed = 5;
  Trees trees(seed);
  int surfaces = 0, stretches = 0;
  for (int i = 0; i < 1500; ++i) {
    const CsgNode root = trees.tree(1 + i % 2);
    const Scene scene = scene_of(root);
    Prepared prepared;
    Settings settings;
    settings.precision = Precision::float64;
    const auto inputs = make_trace_inputs<double>(scene, View{scene.camera, 8, 8}, settings, prepared);
    Silent silent;
    const Intersector<double, Silent> intersector(inputs, silent);
    const Vec3d origin = trees.vec(4);
    Ray<double> ray{origin, trees.vec(1) - origin, 0, std::numeric_limits<double>::infinity(), no_primitive};
    for (int step = 0; step < 20; ++step) {
      const Hit<double> hit = intersector.nearest(ray);
      const double end = hit.found() ? hit.t : 20;
      const bool middle = inside(root, ray.origin + ray.direction * (end / 2));
      for (const double share : {0.03, 0.3, 0.77, 0.97})
        if (end > 1e-6) {
          ASSERT_EQ(inside(root, ray.origin + ray.direction * (end * share)), middle)
              << "seed " << seed << ", tree " << i;
          ++stretches;
        }
      if (!hit.found()) break;
      const SurfacePoint<double> surface = surface_of(ray, hit, inputs);
      if (end > 1e-6) {
        EXPECT_TRUE(inside(root, surface.point - surface.geometric_normal * 1e-9)) << i;
        EXPECT_FALSE(inside(root, surface.point + surface.geometric_normal * 1e-9)) << i;
        EXPECT_EQ(surface.back_face, middle);
      }
      ++surfaces;
      ray = leaving_ray(surface, ray.direction, std::numeric_limits<double>::infinity(), 0.0, inputs);
    }
  }
  EXPECT_GT(surfaces, 1000);
  EXPECT_GT(stretches, 4000);
}

TEST(Csg, FacesThatCoincideLeaveNoSkin) {
  CsgNode whole, hole, root;
  whole.part.form = Brick{{0, 0, 5}, {2, 2, 2}, Mat3d(1.0)};
  hole.part.form = Brick{{0, 0, 4.5}, {1, 1, 1}, Mat3d(1.0)};  // its front lies in the front of the whole
  root.operation = CsgOperation::difference;
  root.children = {whole, hole};
  const Scene scene = scene_of(root);
  Prepared prepared;
  const auto inputs = make_trace_inputs<float>(scene, View{scene.camera, 8, 8}, {}, prepared);
  Silent silent;
  const Ray<float> ray{{0.1f, 0.1f, 0}, {0, 0, 1}, 0, 100, no_primitive};
  const Hit<float> hit = Intersector<float, Silent>(inputs, silent).nearest(ray);
  ASSERT_TRUE(hit.found());
  EXPECT_FLOAT_EQ(hit.t, 5);  // the bottom of the hole
  const SurfacePoint<float> surface = surface_of(ray, hit, inputs);
  EXPECT_EQ(surface.geometric_normal, Vec3f(0, 0, -1)) << "the hole's far face is turned around";
}

// Figure 5-3: the dish of the Death Star is a sphere seen from within.
TEST(Csg, DeathStarsDishIsConcave) {
  const Scene scene = load_scene("cgfs/death-star");
  Prepared prepared;
  const View view{scene.camera, 600, 600};
  const auto inputs = make_trace_inputs<double>(scene, view, {}, prepared);
  Silent silent;
  const auto pixel = Tracer<double, Silent>(inputs, silent).trace_pixel(scene.start_pixel.x, scene.start_pixel.y);
  ASSERT_TRUE(pixel.hit.found());
  EXPECT_EQ(detail_part(pixel.hit.detail), 1u);
  const Vec3d centre{0.75, 0.7, 2.5};
  EXPECT_NEAR(glm::length(pixel.surface.point - centre), 0.65, 1e-9);
  EXPECT_NEAR(dot(pixel.surface.shading_normal, glm::normalize(centre - pixel.surface.point)), 1, 1e-9);
}

TEST(Csg, BadTreesAreTurnedDown) {
  const auto fails = [](const std::string& text, const std::string& word) {
    EXPECT_NE(test::refusal_of([&] { parse_scene(text, "test.scene", {}); }).find(word), std::string::npos);
  };
  fails("union { sphere { center = (0, 0, 0) radius = 1 } }", "two or more");
  fails("union { name = x\n radius = 3\n box { center = (0,0,0) size = 1 }\n box { center = (0,0,0) size = 1 } }",
        "radius");
  fails("union { rectangle { corner = (0,0,0) side_a = (1,0,0) side_b = (0,1,0) } }", "no inside");
  fails("rectangle { corner = (0,0,0) side_a = (1,0,0) side_b = (1,1,0) }", "perpendicular");
  fails("box { center = (0,0,0) size = (1, -1, 1) }", "above 0");
  fails("cylinder { from = (0,0,0) to = (0,0,0) radius = 1 }", "other than");
  std::string many = "union {";
  for (int i = 0; i < 33; ++i) many += " sphere { center = (0,0,0) radius = 1 }";
  fails(many + " }", "at most 32");
}

}  // namespace
}  // namespace ps::csg_test
