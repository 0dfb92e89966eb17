// Triangles for curved models by projected error: the deviation measured on the canvas stays below the tolerance.
#include "raster/setup/tessellate_patches.h"

#include <cmath>

#include <gtest/gtest.h>

#include "raster/setup/tessellate_solid.h"
#include "scene/generate/teapot.h"
#include "scene/load.h"
#include "support/render_once.h"

namespace ps::raster {
namespace patch_tessellation_test {
namespace {

Viewport<double> book_viewport() {
  Viewport<double> viewport;
  viewport.columns = viewport.rows = 600;
  viewport.span_x = viewport.span_y = 600;
  return viewport;
}

TessellationView book_view(double max_error) { return make_tessellation_view(Camera{}, book_viewport(), 1, max_error); }

/// Where the book's camera, in the origin, sees a point; pixels.
Vec2d on_canvas(const Vec3d& p) { return {p.x * 600 / p.z, p.y * 600 / p.z}; }

double apart(const Vec3d& a, const Vec3d& b) {
  const Vec2d d = on_canvas(a) - on_canvas(b);
  return std::hypot(d.x, d.y);
}

/// The teapot's patches standing upright at `place`, half as large.
std::vector<BezierPatch> upright_teapot(const Vec3d& place) {
  std::vector<BezierPatch> patches = teapot_patches();
  for (BezierPatch& patch : patches)
    for (Vec3d& p : patch.control) p = Vec3d{p.x, p.z, -p.y} * 0.5 + place;
  return patches;
}

/// Largest distance on the canvas between a point of a triangle and the surface: along the normal at the point of the
/// surface that has the same u and v. `parts` x `parts` quads for each patch, each looked at in 4 x 4 places.
double measured(const std::vector<BezierPatch>& patches, int parts) {
  constexpr int fine = 4;
  double worst = 0;
  for (const BezierPatch& patch : patches)
    for (int row = 0; row < parts * fine; ++row)
      for (int column = 0; column < parts * fine; ++column) {
        const auto corner = [&](int right, int down) {
          return patch_point(patch, {column / fine + right, parts}, {row / fine + down, parts});
        };
        const double s = (column % fine) / double(fine), t = (row % fine) / double(fine);
        // The diagonal runs from the first corner to the opposite one.
        const Vec3d flat = s >= t
                               ? corner(0, 0) + (corner(1, 0) - corner(0, 0)) * s + (corner(1, 1) - corner(1, 0)) * t
                               : corner(0, 0) + (corner(0, 1) - corner(0, 0)) * t + (corner(1, 1) - corner(0, 1)) * s;
        const PatchParameter u{column, parts * fine}, v{row, parts * fine};
        const Vec3d round = patch_point(patch, u, v), normal = patch_normal(patch, u, v);
        const double strays = std::abs(dot(flat - round, normal));
        worst = std::max(worst, strays * 600 / std::sqrt(dot(round, round)));
      }
  return worst;
}

TEST(PatchTessellation, StaysWithinTheProjectedError) {
  int before = 65;
  for (const double distance : {2.5, 5.0, 10.0, 40.0, 160.0}) {
    const std::vector<BezierPatch> patches = upright_teapot({0.2, -0.5, distance});
    for (const double error : {0.25, 1.0, 8.0}) {
      const int parts = patch_divisions(patches, book_view(error));
      const double worst = measured(patches, parts);
      EXPECT_LE(worst, error) << "distance " << distance << ", " << parts << " parts";
      if (parts > 4) {
        EXPECT_GT(worst, error / 8) << "far more triangles than needed: " << parts << " parts";
      }
    }
    const int parts = patch_divisions(patches, book_view(0.25));
    EXPECT_LE(parts, before);
    before = parts;
  }
  EXPECT_LE(before, 5) << "a teapot of some twenty pixels needs few parts";
  // The test has teeth: with a third of the parts the error is too large.
  const std::vector<BezierPatch> near = upright_teapot({0.2, -0.5, 2.5});
  const int parts = patch_divisions(near, book_view(0.25));
  EXPECT_GT(measured(near, std::max(1, parts / 3)), 0.25);
}

TEST(PatchTessellation, CylinderSidesStayWithinTheProjectedError) {
  for (const double error : {0.2, 1.0, 5.0})
    for (const double distance : {3.0, 12.0}) {
      Solid solid;
      solid.form = Cylinder{{0.3, -1, distance}, {0.1, 1, distance + 0.5}, 0.8};
      const Mesh mesh = tessellate_solid(solid, book_view(error));
      const Vec3d from{0.3, -1, distance}, axis = Vec3d{-0.2, 2, 0.5} / std::sqrt(0.04 + 4 + 0.25);
      double worst = 0;
      for (const MeshTriangle& t : mesh.triangles) {
        const Vec3d normal = mesh.normals[static_cast<std::size_t>(t.normal[0])];
        if (std::abs(dot(normal, axis)) > 0.5) continue;  // a cap
        for (std::size_t k = 0; k < 3; ++k) {
          const Vec3d middle = (mesh.positions[t.position[k]] + mesh.positions[t.position[(k + 1) % 3]]) * 0.5;
          const Vec3d along = from + axis * dot(middle - from, axis);
          const Vec3d out = middle - along;
          const Vec3d round = along + out * (0.8 / std::sqrt(dot(out, out)));
          worst = std::max(worst, apart(middle, round));
        }
      }
      EXPECT_LE(worst, error) << distance;
      EXPECT_GT(worst, error / 20) << distance;
    }
}

// In the picture: with half a pixel the teapot covers the same pixels as one of 64 parts, but for its outline.
TEST(PatchTessellation, DrawsTheSameTeapotWithFewerTriangles) {
  Scene scene = load_scene("cgpp/teapot");
  const auto draw = [&](Patches patches, double error) {
    Settings settings{.renderer = Renderer::rasterizer};
    settings.viewport_fit = ViewportFit::width;
    settings.near = 0.1;
    settings.patches = patches;
    settings.tessellation = error;
    return render(scene, View{scene.camera, 400, 250}, settings, request_for(Channel::ids));
  };
  const Frame fine = draw(Patches::projected_error, 0.05), medium = draw(Patches::projected_error, 0.5);
  const Frame coarse = draw(Patches::projected_error, 30), made = draw(Patches::as_made, 0.5);
  const auto differing = [&](const Frame& frame) {
    int count = 0;
    for (int y = 0; y < 250; ++y)
      for (int x = 0; x < 400; ++x) count += frame.ids.at(x, y).object != fine.ids.at(x, y).object;
    return count;
  };
  const auto triangles = [](const Frame& frame) { return frame.counters[Counter::triangles_in]; };
  EXPECT_LT(differing(medium), 120);
  EXPECT_GT(differing(coarse), 300);
  EXPECT_LT(triangles(coarse), triangles(medium));
  EXPECT_LT(triangles(medium), triangles(fine));
  EXPECT_NE(triangles(made), triangles(medium));
}

}  // namespace
}  // namespace patch_tessellation_test
}  // namespace ps::raster
