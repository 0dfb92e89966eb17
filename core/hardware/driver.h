#pragma once
#include <string>
#include <vector>

namespace ps::hardware {

/// What a graphics driver says of itself.
struct Driver {
  std::string renderer;       ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string vendor;         ///< "Mesa"
  std::string version;        ///< "4.5 (Core Profile) Mesa 22.3.6"
  std::string platform;       ///< how its display was found: "EGL device", "surfaceless", "default display"
  int subpixel_bits = 0;      ///< of the positions of vertices on the canvas
  int max_size = 0;           ///< texels along a side of a texture or a picture
  std::vector<int> samples;   ///< how many a pixel may have besides 1
  int max_block_bytes = 0;    ///< of a uniform block
  bool clip_control = false;  ///< depth may be mapped to 0..1 without rounding it first (ARB_clip_control)
};

}  // namespace ps::hardware
