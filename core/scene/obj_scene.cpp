#include <cmath>

#include "scene/obj.h"

namespace ps {

Scene load_obj_scene(const std::filesystem::path& path) {
  ObjModel model = load_obj(path);
  const BoundingSphere bounds = bounding_sphere(model.mesh);
  const double radius = bounds.radius > 0 ? bounds.radius : 1;

  Scene scene;
  scene.name = path.string();
  scene.title = path.filename().string();
  scene.files = std::move(model.files);
  scene.warnings = std::move(model.warnings);
  scene.background = Vec3d{228, 231, 235} / 255.0;

  // The viewport is as wide as it is far away, so its edge is seen under an angle whose tangent is 1/2. The sphere
  // around the model touches that cone at this distance; a little more leaves a margin.
  const double tangent = 0.5;
  const double margin = 1.05;
  const double distance = margin * radius * std::sqrt(1 + tangent * tangent) / tangent;
  scene.camera.position = bounds.centre + Vec3d{0, 0, distance};
  scene.camera.right = {1, 0, 0};
  scene.camera.up = {0, 1, 0};
  scene.camera.forward = {0, 0, -1};
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
  key.direction = {1, 1.5, 2};
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
