#pragma once
#include <memory>
#include <string>

#include "image/image.h"
#include "math/vec.h"

namespace ps {

/// A picture that surfaces can wear. Texels are linear RGB in [0, 1]; row 0 is the top, v = 0.
struct Texture {
  std::string name;
  std::string path;  ///< where it was read from; empty for pictures made by the program
  std::shared_ptr<const Image<Vec3f>> texels;
  std::string generator{};  ///< how scene/texture_generator.h made it; empty for pictures from files
  bool operator==(const Texture&) const = default;
};

}  // namespace ps
