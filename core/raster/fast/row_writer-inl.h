// A tile's rows on their way from the cache to the picture; compiled once for each SIMD target (Highway).
#if defined(PIXELSCOPE_FAST_ROW_WRITER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_FAST_ROW_WRITER_INL_H_
#undef PIXELSCOPE_FAST_ROW_WRITER_INL_H_
#else
#define PIXELSCOPE_FAST_ROW_WRITER_INL_H_
#endif

#include <cstring>

#include "hwy/cache_control.h"
#include "hwy/highway.h"
#include "raster/fast/resolve.h"

HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace resolving {

namespace hn = hwy::HWY_NAMESPACE;

/// Writes rows of colours, and their display levels, which are made while the colours are in the cache.
class RowWriter {
 public:
  HWY_INLINE RowWriter(const TileRect& rect, const TileOutput& output)
      : rect_(rect), output_(output), wide_(static_cast<std::size_t>(rect.width())) {}

  /// What write() writes from now on: as many colours as the tile has columns, at the beginning of a vector. They stay
  /// the caller's.
  HWY_INLINE void set(const Vec3f* colours) {
    colours_ = colours;
    if (output_.levels) display_row(std::span(colours, wide_), std::span(levels_.data(), wide_), output_.transform);
  }
  HWY_INLINE void write(int row) {
    const auto at = static_cast<std::size_t>(row) * output_.width + static_cast<std::size_t>(rect_.x0);
    put(colours_, output_.pixels + at, wide_ * sizeof(Vec3f), output_.colour_stores);
    if (output_.levels) put(levels_.data(), output_.levels + at, wide_ * sizeof(Rgb8), output_.level_stores);
  }
  /// Publishes what has been written to other threads.
  HWY_INLINE void end() {
    if (output_.colour_stores == Stores::past_cache) hwy::FlushStream();
  }

 private:
  HWY_INLINE static void put(const void* from, void* to, std::size_t bytes, Stores stores) {
    const hn::ScalableTag<std::uint8_t> d;
    const std::size_t step = hn::Lanes(d);
    const auto* source = static_cast<const std::uint8_t*>(from);
    auto* target = static_cast<std::uint8_t*>(to);
    std::size_t i = 0;
    if (stores == Stores::past_cache && reinterpret_cast<std::uintptr_t>(to) % step == 0)
      for (; i + step <= bytes; i += step) hn::Stream(hn::Load(d, source + i), d, target + i);
    std::memcpy(target + i, source + i, bytes - i);
  }

  TileRect rect_;
  const TileOutput& output_;
  std::size_t wide_;
  const Vec3f* colours_ = nullptr;
  alignas(64) std::array<Rgb8, fast_tile> levels_;
};

}  // namespace resolving
}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
