#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "math/vec.h"

namespace ps {

/// Which part of a file's pixels a texture takes; all but `colour` give grey.
enum class TextureChannel { colour, red, green, blue, alpha, luminance };

/// As scene files name it: "alpha".
std::string_view texture_channel_name(TextureChannel channel);

/// A texture image for surfaces. Texels are linear RGB in [0, 1]; row 0 is the top, v = 0.
struct Texture {
  std::string name;
  std::string path;  ///< where it was read from; empty for pictures made by the program
  std::shared_ptr<const Image<Vec3f>> texels;
  std::string generator{};  ///< how scene/texture_generator.h made it; empty for pictures from files
  TextureChannel channel = TextureChannel::colour;
  double base = 0, gain = 1;         ///< each number of the file becomes base + gain * number, clamped to 0..1
  bool clamped = false;              ///< beyond its border the border goes on, whatever the option texture-wrap says
  std::vector<std::string> faces{};  ///< of a cross of six pictures: their files, for -x, +x, -y, +y, -z and +z
  bool operator==(const Texture&) const = default;
};

}  // namespace ps
