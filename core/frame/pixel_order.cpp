#include "frame/pixel_order.h"

#include <algorithm>

#include "frame/region.h"

namespace ps {
namespace {

std::uint64_t area(const TileRect& rect) {
  return static_cast<std::uint64_t>(rect.width()) * static_cast<std::uint64_t>(rect.height());
}

}  // namespace

PixelOrder::PixelOrder(int width, int height, int tile_size, const TileRect& region) : region_(region) {
  for (const TileRect& tile : make_tiles(width, height, tile_size))
    if (const TileRect part = common_part(tile, region); !is_empty(part)) tiles_.push_back(part);
}

std::uint64_t PixelOrder::count(SlowUnit unit) const {
  switch (unit) {
  case SlowUnit::tiles:
    return tiles_.size();
  case SlowUnit::rows:
    return static_cast<std::uint64_t>(region_.height());
  case SlowUnit::pixels:
    return area(region_);
  case SlowUnit::triangles:
  case SlowUnit::fragments:
  case SlowUnit::samples:
  case SlowUnit::writes:
    return 0;
  }
  return 0;
}

std::vector<TileRect> PixelOrder::done(const SlowMotion& motion, SlowState& state) const {
  state.total = count(motion.unit);
  const std::uint64_t at = std::min(motion.at, state.total);
  state.done = {motion.unit, at};
  if (at == 0) return {};
  if (motion.unit == SlowUnit::pixels) return first_pixels(at, state);
  if (motion.unit == SlowUnit::tiles) {
    state.box = tiles_[at - 1];
    return {tiles_.begin(), tiles_.begin() + static_cast<std::ptrdiff_t>(at)};
  }
  const int end = region_.y0 + static_cast<int>(at);
  state.box = TileRect{region_.x0, end - 1, region_.x1, end};
  return {{region_.x0, region_.y0, region_.x1, end}};
}

std::vector<TileRect> PixelOrder::first_pixels(std::uint64_t at, SlowState& state) const {
  std::vector<TileRect> done;
  for (const TileRect& tile : tiles_) {
    if (at >= area(tile)) {
      done.push_back(tile);
      at -= area(tile);
      state.pixel = Vec2i(tile.x1 - 1, tile.y1 - 1);
      if (at == 0) break;
      continue;
    }
    const int rows = static_cast<int>(at / static_cast<std::uint64_t>(tile.width()));
    const int columns = static_cast<int>(at % static_cast<std::uint64_t>(tile.width()));
    const int row = tile.y0 + rows;
    if (rows > 0) done.push_back({tile.x0, tile.y0, tile.x1, row});
    if (columns > 0) done.push_back({tile.x0, row, tile.x0 + columns, row + 1});
    state.pixel = columns > 0 ? Vec2i(tile.x0 + columns - 1, row) : Vec2i(tile.x1 - 1, row - 1);
    break;
  }
  return done;
}

}  // namespace ps
