#include "study/model/reduce.h"

#include <algorithm>
#include <numeric>

#include "image/mip_chain.h"

namespace ps::model {
namespace {

template <class Thing>
void erase_marked(std::vector<Thing>& things, const Marks& marks) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < things.size(); ++i)
    if (!marks[i]) {
      if (kept != i) things[kept] = std::move(things[i]);
      ++kept;
    }
  things.resize(kept);
}

/// The new index of each thing that stays.
std::vector<std::uint32_t> renumbered(const Marks& marks) {
  std::vector<std::uint32_t> numbers(marks.size());
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < marks.size(); ++i) numbers[i] = marks[i] ? 0 : next++;
  return numbers;
}

/// Drops what no object uses.
void drop_unused(Scene& scene) {
  Marks meshes(scene.geometry->meshes.size(), 1), materials(scene.materials->size(), 1),
      textures(scene.textures->size(), 1);
  for (Object object : scene.geometry->objects) {
    for_each_material(object, [&](std::uint32_t index) { materials[index] = 0; });
    const auto* instance = std::get_if<Instance>(&object.shape);
    if (!instance) continue;
    meshes[instance->mesh] = 0;
    for (const std::uint32_t material : scene.geometry->meshes[instance->mesh]->materials) materials[material] = 0;
  }
  for (std::size_t i = 0; i < materials.size(); ++i) {
    Material material = (*scene.materials)[i];
    if (!materials[i])
      for_each_texture(material, [&](int index) {
        if (index >= 0) textures[static_cast<std::size_t>(index)] = 0;
      });
  }
  const std::vector<std::uint32_t> mesh_number = renumbered(meshes), material_number = renumbered(materials),
                                   texture_number = renumbered(textures);
  scene.geometry.edit([&](Geometry& geometry) {
    erase_marked(geometry.meshes, meshes);
    for (auto& mesh : geometry.meshes) {
      Mesh changed = *mesh;
      for (std::uint32_t& material : changed.materials) material = material_number[material];
      mesh = std::make_shared<const Mesh>(std::move(changed));
    }
    for (Object& object : geometry.objects) {
      for_each_material(object, [&](std::uint32_t& index) { index = material_number[index]; });
      if (auto* instance = std::get_if<Instance>(&object.shape)) instance->mesh = mesh_number[instance->mesh];
    }
  });
  scene.materials.edit([&](std::vector<Material>& all) {
    erase_marked(all, materials);
    for (Material& material : all)
      for_each_texture(material, [&](int& index) {
        if (index >= 0) index = static_cast<int>(texture_number[static_cast<std::size_t>(index)]);
      });
  });
  scene.textures.edit([&](std::vector<Texture>& all) { erase_marked(all, textures); });
}

/// Keeps the entries that some triangle uses; `corners` is the triangle's list of them, whose indices change.
template <class Entry, class Index>
void keep_used(std::vector<Entry>& entries, std::vector<MeshTriangle>& triangles,
               std::array<Index, 3> MeshTriangle::*corners) {
  std::vector<Index> number(entries.size(), Index(-1));
  std::vector<Entry> used;
  for (MeshTriangle& triangle : triangles)
    for (Index& corner : triangle.*corners) {
      if (corner == Index(-1)) continue;
      Index& now = number[static_cast<std::size_t>(corner)];
      if (now == Index(-1)) {
        now = static_cast<Index>(used.size());
        used.push_back(entries[static_cast<std::size_t>(corner)]);
      }
      corner = now;
    }
  entries = std::move(used);
}

}  // namespace

std::size_t count_marks(const Marks& marks) { return std::accumulate(marks.begin(), marks.end(), std::size_t{0}); }

Scene without_objects(const Scene& scene, const Marks& objects) {
  Scene less = scene;
  less.geometry.edit([&](Geometry& geometry) { erase_marked(geometry.objects, objects); });
  drop_unused(less);
  return less;
}

Scene without_lights(const Scene& scene, const Marks& lights) {
  Scene less = scene;
  less.lights.edit([&](std::vector<Light>& all) { erase_marked(all, lights); });
  return less;
}

Scene with_mesh(const Scene& scene, std::size_t mesh, Mesh changed) {
  Scene less = scene;
  less.geometry.edit(
      [&](Geometry& geometry) { geometry.meshes[mesh] = std::make_shared<const Mesh>(std::move(changed)); });
  return less;
}

Scene with_coarser_texture(const Scene& scene, std::size_t texture, int level) {
  Scene less = scene;
  less.textures.edit([&](std::vector<Texture>& all) {
    Texture& one = all[texture];
    const MipChain chain = make_mip_chain(one.texels);
    one.texels = std::make_shared<const Image<Vec3f>>(chain.level(std::min(level, chain.levels() - 1)));
    one.path.clear();
    one.generator.clear();
    one.channel = TextureChannel::colour;
    one.base = 0;
    one.gain = 1;
  });
  return less;
}

Mesh without_triangles(const Mesh& mesh, const Marks& triangles) {
  Mesh less = mesh;
  erase_marked(less.triangles, triangles);
  keep_used(less.positions, less.triangles, &MeshTriangle::position);
  keep_used(less.normals, less.triangles, &MeshTriangle::normal);
  keep_used(less.uvs, less.triangles, &MeshTriangle::uv);
  less.materials.clear();
  std::vector<std::optional<std::uint32_t>> slots(mesh.materials.size());
  for (MeshTriangle& triangle : less.triangles) {
    auto& slot = slots[triangle.material];
    if (!slot) {
      slot = static_cast<std::uint32_t>(less.materials.size());
      less.materials.push_back(mesh.materials[triangle.material]);
    }
    triangle.material = *slot;
  }
  less.source.clear();
  less.origins = {};
  return less;
}

std::uint64_t mesh_bytes(const Mesh& mesh) {
  return mesh.positions.size() * sizeof(Vec3d) + mesh.normals.size() * sizeof(Vec3d) + mesh.uvs.size() * sizeof(Vec2d) +
         mesh.triangles.size() * sizeof(MeshTriangle) + mesh.patches.size() * sizeof(BezierPatch);
}

std::uint64_t texture_bytes(const Texture& texture) { return texture.texels->pixels().size_bytes(); }

std::uint64_t model_bytes(const Scene& scene) {
  std::uint64_t bytes = scene.geometry->objects.size() * sizeof(Object) + scene.materials->size() * sizeof(Material) +
                        scene.lights->size() * sizeof(Light);
  for (const auto& mesh : scene.geometry->meshes) bytes += mesh_bytes(*mesh);
  for (const Texture& texture : *scene.textures) bytes += texture_bytes(texture);
  return bytes;
}

}  // namespace ps::model
