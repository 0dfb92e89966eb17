#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "image/read_limit.h"
#include "scene/model_files.h"
#include "scene/mtl_texture.h"
#include "scene/obj.h"
#include "scene/texture_file.h"

namespace ps {

/// The content of a picture of a material file: colours, or one number for each texel.
enum class MtlMapKind { colours, opacity };

/// Reads the pictures that material files name into model.textures, each once. One that is missing or cannot be read
/// gives a warning; the surface then goes without it.
class ObjTextures {
 public:
  /// Pictures are looked for beside the material file, then beside the model.
  ObjTextures(ObjModel& model, std::filesystem::path model_folder)
      : model_(model), model_folder_(std::move(model_folder)) {}

  /// The index of the picture as the options of `map` want it (-mm, -clamp, -imfchan); -1 where it cannot be had.
  int read(const MtlTexture& map, const std::filesystem::path& mtl, MtlMapKind kind = MtlMapKind::colours);

  /// A normal map as it is; heights, which are grey, turned into one. How steep a bump map is meant, the format leaves
  /// open: here white lies as many texels above black as -bm says times 8.
  void add_relief(const MtlTexture& map, const std::filesystem::path& mtl, Material& material);

  /// A sphere's picture, or the six of a cube as one cross (scene/texture_file.h).
  void add_reflections(const std::vector<MtlTexture>& maps, const std::filesystem::path& mtl, Material& material);

 private:
  void add(Texture texture, Image<Vec3f> texels);
  /// With a warning for each note about the file.
  Image<Vec3f> texels_of(const std::filesystem::path& mtl, const MtlTexture& map, const std::filesystem::path& path,
                         const TextureFileOptions& options);
  std::optional<std::filesystem::path> find(const MtlTexture& map, const std::filesystem::path& mtl);
  Texture as_asked(const MtlTexture& map, const std::filesystem::path& path, MtlMapKind kind) const;
  void warn(const std::filesystem::path& mtl, int line, const std::string& text);
  void warn_unreadable(const std::filesystem::path& mtl, const MtlTexture& map, const std::filesystem::path& path,
                       const InputError& error);

  ObjModel& model_;
  std::filesystem::path model_folder_;
  ModelFiles files_;
  std::map<std::string, int> known_;  ///< by path and options, and by what is missing
  std::int64_t texels_left_ = max_read_pixels;
};

}  // namespace ps
