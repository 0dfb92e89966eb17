#include <algorithm>

#include "scene/generate/uv_sphere.h"
#include "study/stability/plain_scene.h"
#include "study/stability/shaded_ball.h"

namespace ps::stability::shadow_terminator {
namespace {

constexpr int terminator_lights = 20;  // each has a bit of the shadow channel

/// A white ball of triangles with smooth normals, radius 1, that fills a square picture from 100 radii away, under
/// directional lights from anywhere.
Scene terminator_scene(Mesh ball, std::uint32_t seed) {
  constexpr double far_away = 100;
  Scene scene = plain_scene("ball", std::move(ball));
  scene.camera.position = {0, 0, -far_away};
  scene.camera.projection_plane_d = far_away;
  scene.camera.viewport_width = scene.camera.viewport_height = 2;
  Random random(seed);
  std::vector<Light> lights;
  for (int i = 0; i < terminator_lights; ++i) {
    lights.push_back({LightKind::directional, 0.5, Vec3d(1)});
    lights.back().direction = random.direction();
  }
  scene.lights = Part<std::vector<Light>>(std::move(lights));
  return scene;
}

/// Where a shadow ray of the smooth ball starts by Hanika (Ray Tracing Gems II ch. 4): the point of a triangle moved
/// onto the tangent planes at its vertices, interpolated.
Vec3d on_tangent_planes(const Mesh& mesh, const MeshTriangle& triangle, const Vec3d& weights) {
  Vec3d point(0), moved(0);
  for (int k = 0; k < 3; ++k) point += mesh.positions[triangle.position[static_cast<std::size_t>(k)]] * weights[k];
  for (int k = 0; k < 3; ++k) {
    const auto vertex = static_cast<std::size_t>(k);
    const Vec3d normal = mesh.normals[static_cast<std::size_t>(triangle.normal[vertex])];
    const double below = std::min(0.0, dot(point - mesh.positions[triangle.position[vertex]], normal));
    moved += (point - normal * below) * weights[k];
  }
  return moved;
}

/// Percentages of the pairs of a pixel and a light that reaches it by the smooth normal.
struct TerminatorShares {
  double dark = 0;        ///< in the ray tracer's own shadow
  double still_dark = 0;  ///< of them, where the ray from the tangent planes enters the mesh, too
};

/// All triangles of a ball lie at least `inside` from its centre: a ray that stays outside that misses them.
bool enters(const Vec3d& from, const Vec3d& direction, double inside) {
  const double along = std::max(0.0, -dot(from, direction) / dot(direction, direction));
  const Vec3d closest = from + direction * along;
  return dot(closest, closest) < inside * inside;
}

TerminatorShares terminator_shares(const BallCut& cut, const StabilityRun& run) {
  const Mesh mesh = make_uv_sphere({cut.slices, cut.stacks});
  const Scene scene = terminator_scene(mesh, run.seed);
  const int side = run.side(200, 100);
  Settings settings;
  settings.near = 0.5;
  const Frame frame = picture_of(scene, {scene.camera, side, side}, settings,
                                 Channel::shadow | Channel::normal | Channel::barycentric | Channel::ids, run);
  const double inside = std::cos(pi / cut.slices) * std::cos(pi / (2 * cut.stacks));
  double lit = 0, dark = 0, still_dark = 0;
  for (std::size_t pixel = 0; pixel < frame.ids.pixels().size(); ++pixel) {
    const PixelId id = frame.ids.pixels()[pixel];
    if (id.object < 0) continue;
    const Vec3d normal(frame.normal.pixels()[pixel]);
    const Vec3d start = on_tangent_planes(mesh, mesh.triangles[static_cast<std::size_t>(id.triangle)],
                                          Vec3d(frame.barycentric.pixels()[pixel]));
    for (std::size_t light = 0; light < scene.lights->size(); ++light) {
      const Vec3d to_light = (*scene.lights)[light].direction;
      if (!(dot(normal, to_light) > 0)) continue;
      ++lit;
      if ((frame.shadow.pixels()[pixel] >> light & 1) == 0) continue;
      ++dark;
      still_dark += enters(start, to_light, inside) ? 1 : 0;
    }
  }
  return {percent(dark, lit), percent(still_dark, lit)};
}

/// Pixels that their interpolated normal turns to a light, but whose triangle faces away from it, so that their shadow
/// ray starts into the mesh. The program has no cure of its own; Hanika's is computed at the pixels that are dark.
void measure_terminator(const StabilityRun& run, Rows& rows) {
  for (const BallCut& cut : {BallCut{12, 6}, BallCut{20, 10}, BallCut{64, 32}, BallCut{256, 128}}) {
    const TerminatorShares shares = terminator_shares(cut, run);
    rows.add(cut.triangles(), "ball with smooth normals", shares.dark, shares.still_dark,
             "% of pixels lit by their normal that are dark");
  }
}

}  // namespace

extern const StabilityExperiment shadow_terminator{
    .key = "shadow-terminator",
    .place = {Subject::shading, 40},
    .title = "The shadow terminator",
    .keywords = "terminator problem, shading normal, low polygon, self-shadowing, acne",
    .knob = "triangles of the ball",
    .naive = "shadow ray from the triangle",
    .robust = "shadow ray from the smooth surface (Hanika)",
    .explanation = "A vertex normal can turn a point to the light although its triangle faces away, and then its "
                   "shadow ray starts "
                   "into the mesh. The share of such points falls with the angle between neighbouring triangles.",
    .safe = "Fine meshes: a quarter of a percent at 65,000 triangles.",
    .window = {65000, everywhere},
    .series = {{.names = "*", .title = "dark pixels among those lit by their normal", .unit = "%"}},
    .add_rows = measure_terminator};

}  // namespace ps::stability::shadow_terminator
