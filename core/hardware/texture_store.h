#pragma once
#include <cstdint>
#include <map>
#include <memory>

#include "image/mip_chain.h"
#include "options/settings.h"

namespace ps::hardware {

/// How the driver reads a texture when it filters itself.
struct DriverFilter {
  TextureFilter filter = TextureFilter::trilinear;
  TextureWrap wrap = TextureWrap::repeat;
  int anisotropy = 1;
};

/// Textures in the memory of the graphics driver, with the levels of our own chains as 32-bit floats.
class TextureStore {
 public:
  ~TextureStore();

  /// Binds the texture to a unit, uploaded if it is not there yet. Throws InputError for one that is larger than
  /// `max_size`.
  void bind(const MipChain& chain, int unit, const DriverFilter& filter, int max_size);
  /// Drops what no scene holds any more. Between pictures.
  void tidy();

 private:
  struct Entry {
    std::weak_ptr<const Image<Vec3f>> base;
    int levels = 0;
    unsigned texture = 0;
  };
  std::map<const Image<Vec3f>*, Entry> entries_;
};

}  // namespace ps::hardware
