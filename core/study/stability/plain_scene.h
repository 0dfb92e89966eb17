#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace ps {

/// These objects, all of one white material, before the book's camera.
inline Scene plain_scene(Geometry geometry) {
  Scene scene;
  scene.geometry = Part<Geometry>(std::move(geometry));
  scene.materials = Part<std::vector<Material>>({Material{}});
  return scene;
}

/// One model, which has one material.
inline Scene plain_scene(std::string name, Mesh mesh, const Transform& transform = {}) {
  mesh.materials = {0};
  Geometry geometry;
  geometry.meshes = {std::make_shared<const Mesh>(std::move(mesh))};
  Instance instance;
  instance.transform = transform;
  geometry.objects.push_back({std::move(name), instance});
  return plain_scene(std::move(geometry));
}

}  // namespace ps
