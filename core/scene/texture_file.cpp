#include "scene/texture_file.h"

#include <algorithm>

#include "image/file.h"

namespace ps {
namespace {

struct CellSize {
  int width = 0, height = 0;
};

CellSize largest_face(const std::array<Image<Vec3f>, 6>& faces) {
  CellSize size;
  for (const Image<Vec3f>& face : faces) {
    size.width = std::max(size.width, face.width());
    size.height = std::max(size.height, face.height());
  }
  return size;
}

float one_channel(const Vec3f& colour, TextureChannel channel) {
  switch (channel) {
  case TextureChannel::red:
    return colour.x;
  case TextureChannel::green:
    return colour.y;
  case TextureChannel::blue:
    return colour.z;
  case TextureChannel::luminance:  // grey stays exactly what it is
    return colour.x == colour.y && colour.y == colour.z ? colour.x
                                                        : 0.2126f * colour.x + 0.7152f * colour.y + 0.0722f * colour.z;
  case TextureChannel::colour:
  case TextureChannel::alpha:
    break;
  }
  return colour.x;
}

}  // namespace

LoadedTexels load_texels(const std::filesystem::path& path, const TextureFileOptions& options) {
  StoredPicture picture = load_picture(path, {.most_pixels = options.most_pixels});
  LoadedTexels loaded{std::move(picture.colour), std::move(picture.notes)};
  Image<Vec3f>& texels = loaded.texels;
  for (std::size_t i = 0; i < texels.pixels().size() && options.channel != TextureChannel::colour; ++i) {
    Vec3f& texel = texels.pixels()[i];
    const bool alpha = options.channel == TextureChannel::alpha;
    texel = !alpha                  ? Vec3f(one_channel(texel, options.channel))
            : picture.alpha.empty() ? Vec3f(1)
                                    : Vec3f(picture.alpha.pixels()[i]);
  }
  if (options.base == 0 && options.gain == 1) return loaded;
  for (Vec3f& texel : texels.pixels())
    for (int i = 0; i < 3; ++i)
      texel[i] = static_cast<float>(std::clamp(options.base + options.gain * static_cast<double>(texel[i]), 0.0, 1.0));
  return loaded;
}

bool has_alpha(const std::filesystem::path& path, std::int64_t most_pixels) {
  const Image<float> alpha = load_picture(path, {.most_pixels = most_pixels}).alpha;
  return std::any_of(alpha.pixels().begin(), alpha.pixels().end(), [](float a) { return a != 1; });
}

std::int64_t cube_cross_texels(const std::array<Image<Vec3f>, 6>& faces) {
  const CellSize cell = largest_face(faces);
  return std::int64_t{12} * cell.width * cell.height;
}

Image<Vec3f> cube_cross(const std::array<Image<Vec3f>, 6>& faces) {
  constexpr std::array<std::array<int, 2>, 6> cells{{{0, 1}, {2, 1}, {1, 2}, {1, 0}, {1, 1}, {3, 1}}};
  const CellSize cell = largest_face(faces);
  Image<Vec3f> cross(4 * cell.width, 3 * cell.height);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Image<Vec3f>& face = faces[i];
    if (face.empty()) continue;
    for (int y = 0; y < cell.height; ++y)
      for (int x = 0; x < cell.width; ++x)
        cross.at(cells[i][0] * cell.width + x, cells[i][1] * cell.height + y) =
            face.at(static_cast<int>(std::int64_t{x} * face.width() / cell.width),
                    static_cast<int>(std::int64_t{y} * face.height() / cell.height));
  }
  return cross;
}

}  // namespace ps
