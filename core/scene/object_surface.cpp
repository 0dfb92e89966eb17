#include "scene/object_surface.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>

#include <fmt/format.h>

#include "base/archived_file.h"
#include "base/check.h"
#include "image/file.h"
#include "scene/scene_draft.h"

namespace ps {
namespace {

constexpr const char* no_texture = "none";

bool has_coordinates(const Mesh& mesh) {
  return !mesh.triangles.empty() && std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [](const auto& triangle) {
    return std::all_of(triangle.uv.begin(), triangle.uv.end(), [](std::int32_t index) { return index >= 0; });
  });
}

/// The material in whose place another can be put; nullopt where there is none, or one for each part of the object.
std::optional<std::uint32_t> own_material(const Object& object) {
  if (const auto* sphere = std::get_if<Sphere>(&object.shape)) return sphere->material;
  if (const auto* solid = std::get_if<Solid>(&object.shape)) return solid->material;
  if (const auto* instance = std::get_if<Instance>(&object.shape)) return instance->material;
  return {};
}

std::uint32_t index_of_material(const Scene& scene, std::size_t index) {
  const Object& object = scene.geometry->objects.at(index);
  if (const auto own = own_material(object)) return *own;
  return scene.geometry->meshes.at(std::get<Instance>(object.shape).mesh)->materials.front();
}

/// Whether some other object, model or part has this material.
bool is_shared(const Scene& scene, std::uint32_t material) {
  int uses = 0;
  for (const auto& mesh : scene.geometry->meshes)
    uses += static_cast<int>(std::count(mesh->materials.begin(), mesh->materials.end(), material));
  for (const Object& object : scene.geometry->objects) {
    if (own_material(object) == material) ++uses;
    if (const auto* csg = std::get_if<Csg>(&object.shape))
      for (const Solid* part : csg_parts(csg->root)) uses += part->material == material ? 1 : 0;
  }
  return uses > 1;
}

void set_material(Object& object, std::uint32_t material) {
  if (auto* sphere = std::get_if<Sphere>(&object.shape)) sphere->material = material;
  if (auto* solid = std::get_if<Solid>(&object.shape)) solid->material = material;
  if (auto* instance = std::get_if<Instance>(&object.shape)) instance->material = material;
}

/// The cached content of a picture file.
struct FileTexels {
  std::shared_ptr<const Image<Vec3f>> texels;
  std::vector<std::string> notes;  // as StoredPicture has them
};

/// A picture file as texels. Edits are applied again with each step of a drag, so the newest ones are kept as long as
/// their files do not change.
FileTexels texels_of_file(const std::string& path) {
  struct Kept {
    std::filesystem::file_time_type changed;
    std::uintmax_t bytes = 0;
    std::weak_ptr<const Image<Vec3f>> texels;  // as long as some scene has them
    std::vector<std::string> notes;
  };
  static std::mutex mutex;
  static std::map<std::string, Kept> kept;
  const std::lock_guard lock(mutex);
  std::error_code error;
  const auto changed = std::filesystem::last_write_time(file_on_disk(path), error);
  const auto bytes = std::filesystem::file_size(file_on_disk(path), error);
  if (const auto known = kept.find(path); known != kept.end()) {
    auto texels = known->second.texels.lock();
    if (texels && known->second.changed == changed && known->second.bytes == bytes)
      return {texels, known->second.notes};
  }
  StoredPicture picture = load_picture(path);
  auto texels = std::make_shared<const Image<Vec3f>>(std::move(picture.colour));
  std::erase_if(kept, [](const auto& entry) { return entry.second.texels.expired(); });
  kept[path] = {changed, bytes, texels, picture.notes};
  return {texels, std::move(picture.notes)};
}

}  // namespace

bool takes_texture(const Scene& scene, std::size_t index) {
  if (index >= scene.geometry->objects.size()) return false;
  const Object& object = scene.geometry->objects[index];
  if (const auto* instance = std::get_if<Instance>(&object.shape))
    return has_coordinates(*scene.geometry->meshes.at(instance->mesh));
  return !std::holds_alternative<Csg>(object.shape);
}

bool has_one_material(const Scene& scene, std::size_t index) {
  if (index >= scene.geometry->objects.size()) return false;
  const Object& object = scene.geometry->objects[index];
  if (own_material(object)) return true;
  const auto* instance = std::get_if<Instance>(&object.shape);
  return instance && scene.geometry->meshes.at(instance->mesh)->materials.size() == 1;
}

const Material& object_material(const Scene& scene, std::size_t object) {
  PS_ASSERT(takes_texture(scene, object) || has_one_material(scene, object), "the object has a material of its own");
  return scene.materials->at(index_of_material(scene, object));
}

void edit_object_material(Scene& scene, std::size_t object, const std::function<void(Material&)>& change) {
  Material changed = object_material(scene, object);
  change(changed);
  if (changed == object_material(scene, object)) return;
  const std::uint32_t before = index_of_material(scene, object);
  const bool own = own_material(scene.geometry->objects[object]).has_value();
  if (own && !is_shared(scene, before)) {
    scene.materials.edit([&](std::vector<Material>& materials) { materials[before] = changed; });
    return;
  }
  const auto added = static_cast<std::uint32_t>(scene.materials->size());
  scene.materials.edit([&](std::vector<Material>& materials) { materials.push_back(changed); });
  scene.geometry.edit([&](Geometry& geometry) { set_material(geometry.objects[object], added); });
}

std::string texture_text(const Scene& scene, int texture) {
  if (texture < 0) return no_texture;
  const Texture& found = scene.textures->at(static_cast<std::size_t>(texture));
  return found.path.empty() ? found.name : found.path;
}

int find_or_add_texture(Scene& scene, const std::string& text) {
  if (text == no_texture) return -1;
  std::size_t texels = 0;
  for (std::size_t i = 0; i < scene.textures->size(); ++i) {
    if (texture_text(scene, static_cast<int>(i)) == text) return static_cast<int>(i);
    texels += scene.textures->at(i).texels->pixels().size();
  }
  Texture texture;
  texture.path = std::filesystem::path(text).lexically_normal().string();
  texture.name = std::filesystem::path(text).stem().string();
  const FileTexels file = texels_of_file(texture.path);
  texture.texels = file.texels;
  if (texels + texture.texels->pixels().size() > max_scene_texels)
    throw InputError(fmt::format("{}: found {} texels with those of the scene, expected at most {}", text,
                                 texels + texture.texels->pixels().size(), max_scene_texels));
  scene.textures.edit([&](std::vector<Texture>& textures) { textures.push_back(texture); });
  for (const std::string& note : file.notes) scene.warnings.push_back(fmt::format("{}: {}.", texture.path, note));
  return static_cast<int>(scene.textures->size() - 1);
}

}  // namespace ps
