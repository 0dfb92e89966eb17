#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "raster/setup/tessellate.h"
#include "render/render.h"
#include "scene/scene_file.h"

namespace ps::sphere_far_side_test {
namespace {

/// Half of the sphere lies nearer than the near plane: only the inside of its far half is seen.
const char* const cut_sphere = R"(
viewport_size = 1 x 1
projection_plane_d = 1
background = black
sphere { center = (0, 0, 0.8)  radius = 0.4  color = blue }
)";

const char* const sphere_over_a_floor = R"(
rectangle { corner=(-6,-1,-1) side_a=(12,0,0) side_b=(0,0,18) color=white }
sphere { center=(0,0,4) radius=0.8 color=red }
sphere { center=(0.4,-0.7,2.5) radius=0.25 color=green }
light { type=ambient intensity=0.2 }
light { type=point intensity=0.8 position=(1,3,8) }
)";

int blue_pixels(const Frame& frame) {
  int count = 0;
  for (const Vec3f& pixel : frame.colour.pixels()) count += pixel.z > 0.5f ? 1 : 0;
  return count;
}

TEST(SphereFarSide, IsSeenThroughTheCutOfTheNearPlane) {
  const Scene scene = parse_scene(cut_sphere, "cut.scene", ".");
  const View view{scene.camera, 150, 150};
  Settings settings;
  settings.lighting = false;
  settings.backface_culling = false;
  const int rays = blue_pixels(render(scene, view, settings));
  settings.renderer = Renderer::rasterizer;
  ASSERT_GT(rays, 5000);
  for (const double error : {0.5, 0.05, 0.02})
    for (const Visibility visibility : {Visibility::depth_buffer, Visibility::painter}) {
      settings.tessellation = error;
      settings.visibility = visibility;
      // As large as the rays' disc but for its outline, which strays by up to the error.
      EXPECT_NEAR(blue_pixels(render(scene, view, settings)), rays, 20 + 300 * error) << error;
    }
}

/// Pixels in which two pictures differ by more than 30 levels of 255.
int far_off(const Frame& a, const Frame& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.colour.pixels().size(); ++i) {
    const Vec3f difference =
        glm::abs(glm::clamp(a.colour.pixels()[i], 0.0f, 1.0f) - glm::clamp(b.colour.pixels()[i], 0.0f, 1.0f));
    count += std::max({difference.x, difference.y, difference.z}) * 255 > 30 ? 1 : 0;
  }
  return count;
}

TEST(SphereFarSide, CastsStencilShadowsThatFinerTrianglesDoNotMakeWorse) {
  const Scene scene = parse_scene(sphere_over_a_floor, "floor.scene", ".");
  const View view{scene.camera, 250, 250};
  const Frame rays = render(scene, view, Settings());
  Settings settings{.renderer = Renderer::rasterizer};
  for (const Shadows shadows : {Shadows::stencil_depth_fail, Shadows::stencil_depth_pass}) {
    settings.shadows = shadows;
    settings.tessellation = 0.5;
    const int coarse = far_off(render(scene, view, settings), rays);
    settings.tessellation = 0.05;
    const int fine = far_off(render(scene, view, settings), rays);
    EXPECT_LE(coarse, 150);
    EXPECT_LE(fine, coarse) << "of " << coarse;
  }
}

/// The volume that the triangles enclose, and whether each edge is shared by two of them in opposite senses.
struct Enclosed {
  double volume = 0;
  bool closed = true;
};
Enclosed enclosed_by(const Mesh& mesh, const Vec3d& centre) {
  Enclosed enclosed;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const MeshTriangle& t : mesh.triangles) {
    const auto corner = [&](std::size_t k) { return mesh.positions[t.position[k]] - centre; };
    enclosed.volume += dot(corner(0), cross(corner(1), corner(2))) / 6;
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t.position[k], t.position[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges)
    enclosed.closed = enclosed.closed && count == 1 && edges.count({edge.second, edge.first}) == 1;
  return enclosed;
}

TEST(SphereFarSide, IsAClosedSurfaceOfTheSpheresVolume) {
  for (const Sphere& sphere : {Sphere{{0, -1, 3}, 1, 0}, Sphere{{0, 0, 0.8}, 0.4, 0}, Sphere{{0, -5001, 0}, 5000, 0}}) {
    Viewport<double> viewport;
    viewport.columns = viewport.rows = 800;
    viewport.span_x = viewport.span_y = 800;
    raster::TessellationView view = raster::make_tessellation_view(Camera{}, viewport, 1, 0.02);
    EXPECT_FALSE(enclosed_by(raster::tessellate_sphere(sphere, view), sphere.centre).closed) << "took few triangles";
    view.far_side = raster::FarSide::seen;
    const Enclosed body = enclosed_by(raster::tessellate_sphere(sphere, view), sphere.centre);
    EXPECT_TRUE(body.closed);
    const double ball = 4 * 3.14159265358979 / 3 * sphere.radius * sphere.radius * sphere.radius;
    EXPECT_NEAR(body.volume / ball, 1, 0.01);
  }
}

}  // namespace
}  // namespace ps::sphere_far_side_test
