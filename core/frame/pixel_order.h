#pragma once
#include <vector>

#include "base/parallel.h"
#include "frame/slow_motion.h"

namespace ps {

/// The order in which a picture made tile by tile stores its pixels on one thread.
class PixelOrder {
 public:
  /// The order for a picture of this size in tiles of `tile_size`, of which only `region` is wanted.
  PixelOrder(int width, int height, int tile_size, const TileRect& region);

  std::uint64_t count(SlowUnit unit) const;
  /// The pixels stored after the first `at` tiles, rows or pixels; sets what the last one was. Any other unit: none.
  std::vector<TileRect> done(const SlowMotion& motion, SlowState& state) const;

 private:
  std::vector<TileRect> first_pixels(std::uint64_t at, SlowState& state) const;

  TileRect region_;
  std::vector<TileRect> tiles_;  // those parts that are wanted
};

}  // namespace ps
