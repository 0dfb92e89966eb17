#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "image/image.h"
#include "scene/texture.h"

namespace ps {

/// How a texture's texels are made from the pixels of a file.
struct TextureFileOptions {
  TextureChannel channel = TextureChannel::colour;
  double base = 0, gain = 1;  ///< see Texture
  std::int64_t most_pixels = 0;
};

struct LoadedTexels {
  Image<Vec3f> texels;
  std::vector<std::string> notes;  ///< as StoredPicture has them
};

/// Reads the texels of a texture. Luminance weighs red, green and blue as Rec. 709 does. Throws InputError as
/// load_picture() does.
LoadedTexels load_texels(const std::filesystem::path& path, const TextureFileOptions& options);

/// Whether any pixel of the file is not opaque. Throws InputError.
bool has_alpha(const std::filesystem::path& path, std::int64_t most_pixels);

/// The cross of a folded-out cube (cube_cross_uv) from pictures of its faces, for -x, +x, -y, +y, -z and +z, each
/// upright as seen from the inside. All cells are as large as the largest picture; smaller ones are enlarged texel by
/// texel, and empty ones stay black, as do the corners.
Image<Vec3f> cube_cross(const std::array<Image<Vec3f>, 6>& faces);
/// How many texels that takes.
std::int64_t cube_cross_texels(const std::array<Image<Vec3f>, 6>& faces);

}  // namespace ps
