#include "scene/obj_textures.h"

#include <algorithm>

#include <fmt/format.h>

#include "image/height_map.h"
#include "scene/obj_line.h"
#include "scene/picture_fault.h"
#include "scene/texture_generator.h"

namespace ps {
namespace {

namespace fs = std::filesystem;

TextureChannel asked_channel(char channel) {
  switch (channel) {
  case 'r':
    return TextureChannel::red;
  case 'g':
    return TextureChannel::green;
  case 'b':
    return TextureChannel::blue;
  case 'm':
    return TextureChannel::alpha;
  }
  return TextureChannel::luminance;
}

/// Place of a cube's face among -x, +x, -y, +y, -z and +z. Its front is -z, where OBJ models are looked at from +z.
std::size_t face_index(ReflectionPart part) {
  switch (part) {
  case ReflectionPart::left:
    return 0;
  case ReflectionPart::right:
    return 1;
  case ReflectionPart::bottom:
    return 2;
  case ReflectionPart::top:
    return 3;
  case ReflectionPart::front:
  case ReflectionPart::none:
  case ReflectionPart::sphere:
    return 4;
  case ReflectionPart::back:
    return 5;
  }
  return 4;
}

}  // namespace

void ObjTextures::warn(const fs::path& mtl, int line, const std::string& text) {
  model_.warnings.push_back(fmt::format("{}:{}: {}.", mtl.string(), line, text));
}

void ObjTextures::warn_unreadable(const fs::path& mtl, const MtlTexture& map, const fs::path& path,
                                  const InputError& error) {
  warn(mtl, map.line,
       fmt::format("the texture '{}' cannot be read, so the surface goes without it: {}", map.name,
                   picture_fault(path, error)));
}

Image<Vec3f> ObjTextures::texels_of(const fs::path& mtl, const MtlTexture& map, const fs::path& path,
                                    const TextureFileOptions& options) {
  LoadedTexels loaded = load_texels(path, options);
  for (const std::string& note : loaded.notes) warn(mtl, map.line, fmt::format("the texture '{}' {}", map.name, note));
  return std::move(loaded.texels);
}

void ObjTextures::add(Texture texture, Image<Vec3f> texels) {
  texels_left_ -= static_cast<std::int64_t>(texels.pixels().size());
  texture.texels = std::make_shared<const Image<Vec3f>>(std::move(texels));
  model_.textures.push_back(std::move(texture));
}

/// The picture's file; with a warning for the first material that names a missing one.
std::optional<fs::path> ObjTextures::find(const MtlTexture& map, const fs::path& mtl) {
  std::optional<fs::path> path;
  for (const std::string& meant : meant_names(map.name))
    if (!path) path = files_.find({mtl.parent_path(), model_folder_}, meant);
  if (!path && known_.try_emplace("missing " + map.name, -1).second)
    warn(mtl, map.line, fmt::format("the texture '{}' is missing", map.name));
  return path;
}

Texture ObjTextures::as_asked(const MtlTexture& map, const fs::path& path, MtlMapKind kind) const {
  Texture texture;
  texture.name = path.stem().string();
  texture.path = path.string();
  texture.clamped = map.clamped;
  texture.base = map.base;
  texture.gain = map.gain;
  if (kind == MtlMapKind::colours) return texture;
  // Programs write the opacity where they like: as the picture's own, or in grey.
  const bool own = map.channel == 0 && has_alpha(path, texels_left_);
  texture.channel = own ? TextureChannel::alpha : asked_channel(map.channel);
  return texture;
}

int ObjTextures::read(const MtlTexture& map, const fs::path& mtl, MtlMapKind kind) {
  const auto path = find(map, mtl);
  if (!path) return -1;
  const std::string key = fmt::format("{} {} {} {} {} {}", path->string(), map.base, map.gain, map.clamped,
                                      static_cast<int>(kind), kind == MtlMapKind::opacity ? int{map.channel} : 0);
  const auto [known, is_new] = known_.try_emplace(key, -1);
  if (!is_new) return known->second;
  model_.files.push_back(path->string());  // also one that cannot be read: it may be repaired while the model is open
  try {
    Texture texture = as_asked(map, *path, kind);
    auto texels = texels_of(mtl, map, *path, {texture.channel, texture.base, texture.gain, texels_left_});
    add(std::move(texture), std::move(texels));
  } catch (const InputError& error) {
    warn_unreadable(mtl, map, *path, error);
    return -1;
  }
  return known->second = static_cast<int>(model_.textures.size()) - 1;
}

void ObjTextures::add_relief(const MtlTexture& map, const fs::path& mtl, Material& material) {
  const int index = read(map, mtl);
  material.normal_map = index;
  if (index < 0) return;
  Texture relief = model_.textures[static_cast<std::size_t>(index)];
  const auto heights = relief.texels;
  if (!is_height_map(*heights) || !(map.bump > 0)) return;
  if (static_cast<std::int64_t>(heights->pixels().size()) > texels_left_) {
    material.normal_map = -1;
    warn(mtl, map.line, fmt::format("no room is left for the normals of the relief '{}'", map.name));
    return;
  }
  constexpr double texels_of_bump = 8;
  const double steepness = map.bump * texels_of_bump;
  relief.name += " relief";
  relief.generator = heights_generator(steepness);
  add(std::move(relief), normals_from_heights(*heights, steepness));
  material.normal_map = static_cast<int>(model_.textures.size()) - 1;
  material.height_map = index;
  material.relief_depth = std::min(steepness / heights->width(), 1.0);
}

void ObjTextures::add_reflections(const std::vector<MtlTexture>& maps, const fs::path& mtl, Material& material) {
  const MtlTexture& last = maps.back();
  if (last.part == ReflectionPart::none || last.part == ReflectionPart::sphere) {
    material.reflection_map = read(last, mtl);
    return;
  }
  material.surroundings = Surroundings::cube;
  std::array<Image<Vec3f>, 6> faces;
  Texture cross;
  cross.name = "cube";
  cross.faces.resize(faces.size());
  for (const MtlTexture& map : maps) {
    const auto path = find(map, mtl);
    if (!path || map.part == ReflectionPart::none || map.part == ReflectionPart::sphere) continue;
    const std::size_t face = face_index(map.part);
    model_.files.push_back(path->string());
    try {
      faces[face] = texels_of(mtl, map, *path, {.base = map.base, .gain = map.gain, .most_pixels = texels_left_});
      cross.faces[face] = path->string();
      cross.base = map.base;
      cross.gain = map.gain;
    } catch (const InputError& error) {
      warn_unreadable(mtl, map, *path, error);
    }
  }
  const auto empty = std::count_if(faces.begin(), faces.end(), [](const Image<Vec3f>& face) { return face.empty(); });
  if (empty == static_cast<std::ptrdiff_t>(faces.size())) return;
  if (empty > 0) warn(mtl, last.line, fmt::format("{} of the 6 faces of the cube are missing and stay black", empty));
  if (cube_cross_texels(faces) > texels_left_)
    return warn(mtl, last.line, "no room is left for the cube of pictures, so the surface goes without it");
  add(std::move(cross), cube_cross(faces));
  material.reflection_map = static_cast<int>(model_.textures.size()) - 1;
}

}  // namespace ps
