#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/check.h"
#include "base/enumerators.h"
#include "image/height_map.h"
#include "scene/picture_fault.h"
#include "scene/scene_draft.h"
#include "scene/texture_file.h"
#include "scene/texture_generator.h"

namespace ps {
namespace {

/// Reads one texture block.
class TextureReader {
 public:
  TextureReader(const SceneSource& source, const SceneEntry& entry, const SceneFields& fields, SceneDraft& draft)
      : source_(source), values_(source.values), entry_(entry), fields_(fields), draft_(draft) {}

  Texture read() {
    texture_.name = values_.name(fields_.require("name"));
    if (const SceneTerm* clamp = fields_.find("clamp")) texture_.clamped = values_.on_off(*clamp);
    Image<Vec3f> texels = pictured();
    texture_.texels = std::make_shared<const Image<Vec3f>>(std::move(texels));
    return std::move(texture_);
  }

 private:
  Image<Vec3f> pictured() {
    if (const SceneTerm* file = fields_.find("file")) {
      fields_.forbid({"generator", "size", "cube"}, "only one of 'file', 'cube' and 'generator'");
      return from_file(*file);
    }
    if (const SceneTerm* cube = fields_.find("cube")) {
      fields_.forbid({"generator", "size", "heights", "channel"}, "only one of 'file', 'cube' and 'generator'");
      return from_cube(*cube);
    }
    fields_.forbid({"heights", "channel", "levels"}, "a 'file' beside it");
    return generated();
  }

  Image<Vec3f> from_file(const SceneTerm& file) {
    if (const SceneTerm* channel = fields_.find("channel")) texture_.channel = channel_of(*channel);
    read_levels();
    Image<Vec3f> texels = picture(file, texture_.path);
    if (const SceneTerm* heights = fields_.find("heights")) {
      texture_.generator = heights_generator(values_.positive(*heights));
      texels = normals_from_heights(texels, values_.positive(*heights));
    }
    charge_texels(source_, entry_, texels.pixels().size(), draft_);
    return texels;
  }

  Image<Vec3f> from_cube(const SceneTerm& cube) {
    std::array<Image<Vec3f>, 6> faces;
    if (!cube.is_list() || cube.items.size() != faces.size())
      values_.fail(cube, "six files for -x, +x, -y, +y, -z and +z, or 'none' in place of some");
    read_levels();
    texture_.faces.resize(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
      if (cube.items[i].text != "none") faces[i] = picture(cube.items[i], texture_.faces[i]);
    const std::int64_t texels = cube_cross_texels(faces);
    if (texels == 0) values_.fail(cube, "at least one file");
    charge_texels(source_, entry_, static_cast<std::size_t>(texels), draft_);
    return cube_cross(faces);
  }

  Image<Vec3f> generated() {
    const SceneTerm& generator = fields_.require("generator");
    texture_.generator = values_.name(generator);
    const auto known = texture_generators();
    if (std::find(known.begin(), known.end(), texture_.generator) == known.end())
      values_.fail(generator, fmt::format("one of {}", fmt::join(known, ", ")));
    const int size = fields_.find("size") != nullptr ? values_.whole(*fields_.find("size"), 1, 4096) : 256;
    const std::size_t texels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
    charge_texels(source_, entry_, texels, draft_);
    return generate_texture(texture_.generator, size);
  }

  TextureChannel channel_of(const SceneTerm& term) const {
    if (const auto channel = enumerator_named<TextureChannel>(values_.name(term))) return *channel;
    values_.fail(term, "colour, red, green, blue, alpha or luminance");
  }

  /// levels = (BASE, GAIN)
  void read_levels() {
    const SceneTerm* levels = fields_.find("levels");
    if (levels == nullptr) return;
    const Vec2d value = values_.vec2(*levels);
    texture_.base = value.x;
    texture_.gain = value.y;
  }

  /// A picture that cannot be read is a fault of the line that names it.
  Image<Vec3f> picture(const SceneTerm& term, std::string& name) {
    const auto path = (source_.folder / values_.name(term, "a file name")).lexically_normal();
    name = path.string();
    draft_.scene.files.push_back(name);
    try {
      LoadedTexels loaded =
          load_texels(path, {.channel = texture_.channel,
                             .base = texture_.base,
                             .gain = texture_.gain,
                             .most_pixels = static_cast<std::int64_t>(max_scene_texels - draft_.texels)});
      for (const std::string& note : loaded.notes)
        draft_.scene.warnings.push_back(
            fmt::format("{}:{}: the picture '{}' {}.", values_.file(), term.line, name, note));
      return std::move(loaded.texels);
    } catch (const InputError& error) {
      values_.fail_at(term.line, term.column, fmt::format("the picture '{}' ({})", name, picture_fault(path, error)),
                      "one that can be read");
    }
  }

  const SceneSource& source_;
  const SceneValues& values_;
  const SceneEntry& entry_;
  const SceneFields& fields_;
  SceneDraft& draft_;
  Texture texture_;
};

}  // namespace

std::string_view texture_channel_name(TextureChannel channel) { return enumerator_key(channel); }

void read_texture(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneFields fields(source.values, entry,
                           {"name", "file", "cube", "channel", "levels", "clamp", "heights", "generator", "size"});
  const SceneTerm& name = fields.require("name");
  if (draft.texture_index.count(source.values.name(name)) > 0)
    source.values.fail(name, "a name that no other texture has");
  Texture texture = TextureReader(source, entry, fields, draft).read();
  draft.texture_index[texture.name] = static_cast<int>(draft.textures.size());
  draft.textures.push_back(std::move(texture));
}

}  // namespace ps
