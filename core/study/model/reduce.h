#pragma once
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace ps::model {

/// Which of a scene's things go, by index: 1 = it goes.
using Marks = std::vector<std::uint8_t>;
std::size_t count_marks(const Marks& marks);

/// The scene without these objects, and without the meshes, materials and textures that no other object uses.
Scene without_objects(const Scene& scene, const Marks& objects);
Scene without_lights(const Scene& scene, const Marks& lights);
/// The scene with this mesh in place of one of its own. Its materials are slots of the one before.
Scene with_mesh(const Scene& scene, std::size_t mesh, Mesh changed);
/// The scene with the texture at a coarser level of its own means (image/mip_chain.h).
Scene with_coarser_texture(const Scene& scene, std::size_t texture, int level);

/// The mesh without these triangles, and without the vertices and material slots that only they use. Its slots are in
/// the order of their first use, as an OBJ file has them; it no longer stands in a file.
Mesh without_triangles(const Mesh& mesh, const Marks& triangles);

/// Calls visit(index) for each reference of an object to a material of the scene, which it may change.
template <class Visit>
void for_each_material(Object& object, Visit&& visit) {
  if (auto* sphere = std::get_if<Sphere>(&object.shape)) visit(sphere->material);
  if (auto* solid = std::get_if<Solid>(&object.shape)) visit(solid->material);
  if (auto* csg = std::get_if<Csg>(&object.shape))
    for (Solid* part : csg_parts(csg->root)) visit(part->material);
  if (auto* instance = std::get_if<Instance>(&object.shape); instance && instance->material) visit(*instance->material);
}

/// Calls visit(index) for each reference of a material to a texture, -1 for none, which it may change.
template <class Visit>
void for_each_texture(Material& material, Visit&& visit) {
  for (int* map : {&material.texture, &material.normal_map, &material.height_map, &material.specular_map,
                   &material.ambient_map, &material.opacity_map, &material.reflection_map})
    visit(*map);
}

/// Bytes of all that describes what is seen: vertices, triangles, patches, texels, objects, materials and lights.
std::uint64_t model_bytes(const Scene& scene);
std::uint64_t mesh_bytes(const Mesh& mesh);
std::uint64_t texture_bytes(const Texture& texture);

}  // namespace ps::model
