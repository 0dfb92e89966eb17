#include "bench/meshes.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "scene/generate/displaced_sphere.h"
#include "scene/generate/teapot.h"
#include "scene/generate/torus_knot.h"

namespace ps::bench {

std::shared_ptr<const Mesh> bench_mesh(const std::string& name) {
  if (name == "teapot") return std::make_shared<const Mesh>(make_teapot());
  if (name == "200k") return std::make_shared<const Mesh>(make_torus_knot());
  if (name == "1M") return std::make_shared<const Mesh>(make_displaced_sphere({.divisions = 289}));
  throw InputError("no bench mesh is called " + name);
}

std::shared_ptr<const Mesh> sphere_of(int triangles) {
  const int divisions = std::max(1, static_cast<int>(std::lround(std::sqrt(triangles / 12.0))));
  return std::make_shared<const Mesh>(make_displaced_sphere({.divisions = divisions}));
}

Scene mesh_scene(std::shared_ptr<const Mesh> mesh) {
  const BoundingSphere bounds = bounding_sphere(*mesh);
  Scene scene;
  scene.name = mesh->name;
  scene.background = {0, 0, 0};
  Geometry geometry;
  geometry.meshes = {std::move(mesh)};
  geometry.objects = {{scene.name, Instance{}}};
  scene.geometry = Part<Geometry>(std::move(geometry));
  Material material;
  material.colour = {0.8, 0.6, 0.4};
  material.specular = 30;
  scene.materials = Part<std::vector<Material>>({material});
  Light ambient, point;
  ambient.intensity = 0.2;
  point.kind = LightKind::point;
  point.intensity = 0.7;
  point.position = bounds.centre + bounds.radius * Vec3d{5, -1, 2};
  scene.lights = Part<std::vector<Light>>({ambient, point});
  return scene;
}

View framed_view(const Mesh& mesh, int width, int height) {
  const BoundingSphere bounds = bounding_sphere(mesh);
  View view;
  view.width = width;
  view.height = height;
  Camera& camera = view.camera;
  camera.forward = glm::normalize(Vec3d{-0.5, 1, -0.45});  // the meshes stand on z, as the teapot does
  camera.right = glm::normalize(cross(camera.forward, Vec3d{0, 0, 1}));
  camera.up = cross(camera.right, camera.forward);
  camera.position = bounds.centre - camera.forward * (2.7 * bounds.radius);
  double half_height = 0;
  for (const Vec3d& position : mesh.positions) {
    const Vec3d from_eye = position - camera.position;
    const double z = dot(from_eye, camera.forward);
    half_height = std::max({half_height, std::abs(dot(from_eye, camera.up)) / z,
                            std::abs(dot(from_eye, camera.right)) / z * height / width});
  }
  camera.viewport_height = 2 * half_height * 1.02;
  camera.viewport_width = camera.viewport_height * width / height;
  return view;
}

}  // namespace ps::bench
