#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "math/unit.h"
#include "scene/obj.h"

namespace ps {
namespace {

/// A model in a unit sphere: where its surface faces.
struct Facing {
  double area = 0;                ///< sum over all triangles, as are the others
  double volume = 0, turned = 0;  ///< signed, as seen from the centre; and its parts without sign
  Vec3d sum{0, 0, 0};             ///< of the normals times the area
  Mat3<double> squares{0};        ///< of the normals' products times the area
};

/// Calls `take` with a vertex and the normal of each triangle that has an area, which is the normal's length.
template <class Take>
void each_normal(const Mesh& mesh, const BoundingSphere& bounds, Take take) {
  const auto place = [&](std::uint32_t i) { return (mesh.positions[i] - bounds.centre) / bounds.radius; };
  for (const MeshTriangle& triangle : mesh.triangles) {
    const Vec3d a = place(triangle.position[0]);
    const Vec3d normal = cross(place(triangle.position[1]) - a, place(triangle.position[2]) - a) / 2.0;
    if (dot(normal, normal) > 0) take(a, normal);
  }
}

Facing facing_of(const Mesh& mesh, const BoundingSphere& bounds) {
  Facing facing;
  each_normal(mesh, bounds, [&](const Vec3d& a, const Vec3d& normal) {
    const double area = std::sqrt(dot(normal, normal));
    facing.area += area;
    facing.volume += dot(a, normal);
    facing.turned += std::abs(dot(a, normal));
    facing.sum += normal;
    facing.squares += glm::outerProduct(normal, normal / area);
  });
  return facing;
}

/// The direction of most of the surface's normals, either way: the eigenvector of the largest eigenvalue. Squaring the
/// matrix makes the others vanish.
Vec3d main_normal(Mat3<double> squares) {
  for (int i = 0; i < 30; ++i) {
    squares *= squares;
    squares /= squares[0][0] + squares[1][1] + squares[2][2];
  }
  int longest = 0;
  for (const int column : {1, 2})
    if (squares[column][column] > squares[longest][longest]) longest = column;
  return unit_of(squares[longest]);
}

/// Where the camera stands, from the model: in front of it (+z), to its right and above, so that three sides of a box
/// are seen; straight in front of a flat one, unless that would show its edge.
Vec3d viewing_side(const Mesh& mesh, const BoundingSphere& bounds, const Facing& facing) {
  const Vec3d front{0, 0, 1}, three_quarter = unit_of(Vec3d{0.55, 0.4, 0.8});
  Vec3d normal = main_normal(facing.squares);
  double low = 1, high = -1;
  for (const MeshTriangle& triangle : mesh.triangles) {
    for (const std::uint32_t i : triangle.position) {
      const double height = dot((mesh.positions[i] - bounds.centre) / bounds.radius, normal);
      low = std::min(low, height);
      high = std::max(high, height);
    }
  }
  constexpr double thin = 0.2;     // of a diameter of 2
  constexpr double edge_on = 0.2;  // sine of the angle at which it is seen
  if (high - low > thin) return three_quarter;
  if (std::abs(normal.z) > edge_on) return front;
  // From the side of its fronts; if it has as many there as here, from above, from the right, or from the front.
  constexpr double decided = 0.01;
  double side = dot(facing.sum, normal);
  if (std::abs(side) < decided * facing.area) side = std::abs(normal.y) > 0.5 ? normal.y : normal.x + normal.z;
  return side < 0 ? Vec3d{0, 0, 0} - normal : normal;
}

/// Why the model is not visible in its default view; empty if it is.
std::string view_fault(const Mesh& mesh, const BoundingSphere& bounds, const Facing& facing, const Vec3d& side) {
  if (!(facing.area > 0)) return "no triangle of the model has an area, so nothing is in view";
  double shown = 0, shown_front = 0;
  each_normal(mesh, bounds, [&](const Vec3d&, const Vec3d& normal) {
    shown += std::abs(dot(normal, side));
    shown_front += std::max(dot(normal, side), 0.0);
  });
  constexpr double edges_alone = 1e-3;
  if (shown < edges_alone * facing.area)
    return "every face of the model is shown from its edge in this view; look at it from another side";
  constexpr double most = 0.9;
  const bool inside_out = facing.volume < -most * facing.turned && std::abs(facing.turned) > 1e-6 * facing.area;
  if (!inside_out && shown_front > 0) return {};
  return "the faces run clockwise, so their backs are seen: rasterizers leave them out with backface-culling = on";
}

}  // namespace

Scene load_obj_scene(const std::filesystem::path& path) {
  ObjModel model = load_obj(path);
  const BoundingSphere bounds = bounding_sphere(model.mesh);
  const double radius = bounds.radius > 0 ? bounds.radius : 1;
  const BoundingSphere unit{bounds.centre, radius};
  const Facing facing = facing_of(model.mesh, unit);
  Vec3d side{0, 0, 1};
  if (facing.area > 0) side = viewing_side(model.mesh, unit, facing);
  const std::string fault = view_fault(model.mesh, unit, facing, side);

  Scene scene;
  scene.name = path.string();
  scene.title = path.filename().string();
  scene.files = std::move(model.files);
  scene.warnings = std::move(model.warnings);
  if (!fault.empty()) scene.warnings.push_back(fmt::format("{}: {}.", path.string(), fault));
  scene.background = Vec3d{228, 231, 235} / 255.0;

  // The viewport is as wide as it is far away, so its edge is seen under an angle whose tangent is 1/2. The sphere
  // around the model touches that cone at this distance; a little more leaves a margin.
  const double tangent = 0.5;
  const double margin = 1.05;
  const double distance = margin * radius * std::sqrt(1 + tangent * tangent) / tangent;
  scene.camera.position = bounds.centre + side * distance;
  // Sums with 0 leave no -0, which pictures could show.
  scene.camera.forward = Vec3d{0, 0, 0} - side;
  // Up is y, or for a look from above or below what lies behind or in front of the model.
  constexpr double steep = 0.9;
  const Vec3d upwards = std::abs(side.y) < steep ? Vec3d{0, 1, 0} : Vec3d{0, 0, side.y > 0 ? -1 : 1};
  scene.camera.up = unit_of(upwards - dot(upwards, side) * side);
  scene.camera.right = Vec3d{0, 0, 0} + cross(scene.camera.forward, scene.camera.up);
  // The near limit lies in the viewport by default; half-way to the model it cuts into none, however small.
  const double halfway = (distance - radius) / 2;
  scene.camera.projection_plane_d = halfway;
  scene.camera.viewport_width = halfway;
  scene.camera.viewport_height = halfway;

  Light ambient;
  ambient.intensity = 0.3;
  Light key;
  key.kind = LightKind::directional;
  key.intensity = 0.7;
  key.direction = scene.camera.right + 1.5 * scene.camera.up + 2.0 * side;
  scene.lights = Part<std::vector<Light>>({ambient, key});

  Geometry geometry;
  geometry.objects.push_back({model.mesh.name, Instance{}});
  geometry.meshes.push_back(std::make_shared<const Mesh>(std::move(model.mesh)));
  scene.geometry = Part<Geometry>(std::move(geometry));
  scene.materials = Part<std::vector<Material>>(std::move(model.materials));
  scene.textures = Part<std::vector<Texture>>(std::move(model.textures));
  return scene;
}

}  // namespace ps
