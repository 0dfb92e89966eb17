#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <utility>

#include "image/mip_chain.h"
#include "math/vec.h"
#include "options/settings.h"

namespace ps::hardware {

/// Textures in the memory of the graphics driver, with the levels of our own chains as 32-bit floats.
class TextureStore {
 public:
  TextureStore() = default;
  ~TextureStore();
  TextureStore(const TextureStore&) = delete;
  TextureStore& operator=(const TextureStore&) = delete;

  /// Binds the texture to a unit, uploaded if it is not there yet, for the reader that the settings ask for: a shader,
  /// which reads all levels from one picture, or the driver. Gives the layout for texturing.glsl. Throws InputError for
  /// a texture that needs more than `max_size` along a side, or more memory than there is.
  Vec4<int> bind(const MipChain& chain, int unit, const Settings& settings, int max_size);
  /// Drops what no scene holds any more, and beyond a gigabyte what was not used for the longest time. Between
  /// pictures.
  void tidy();
  /// Drops them all, between pictures.
  void clear();

 private:
  struct Entry {
    std::weak_ptr<const Image<Vec3f>> base;
    int levels = 0;
    unsigned texture = 0;
    std::uint64_t bytes = 0, used = 0;
  };
  std::map<std::pair<const Image<Vec3f>*, HardwareTexturing>, Entry> entries_;
  std::uint64_t clock_ = 0;
};

}  // namespace ps::hardware
