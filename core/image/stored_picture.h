#pragma once
#include <string>
#include <vector>

#include "image/image.h"
#include "math/vec.h"

namespace ps {

/// A picture as its file holds it.
struct StoredPicture {
  Image<Vec3f> colour;
  Image<float> alpha;              ///< opacity of each pixel, 0..1; empty where the file has none: opaque
  std::vector<std::string> notes;  ///< what is unusual about the file, to be said after its name: "has no IEND chunk"
  bool operator==(const StoredPicture&) const = default;
};

}  // namespace ps
