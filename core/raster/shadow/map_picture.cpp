#include "raster/shadow/map_picture.h"

#include <algorithm>

namespace ps::raster {
namespace {

void paint(const Image<float>& map, int left, int top, int side, Image<float>& picture) {
  each_pixel(left, top, side, picture.width(), picture.height(), [&](int x, int y, double u, double v) {
    picture.at(x, y) = map.at(static_cast<int>(u * map.width()), static_cast<int>(v * map.height()));
  });
}

}  // namespace

Vec2i cross_cell(int face) {
  static constexpr std::array<std::array<int, 2>, 6> cells{{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}};
  const auto& cell = cells.at(static_cast<std::size_t>(face));
  return {cell[0], cell[1]};
}

void lay_out_maps(const ShadowMaps& maps, Image<float>& picture) {
  const auto count =
      static_cast<int>(std::count_if(maps.begin(), maps.end(), [](const auto& m) { return m.size > 0; }));
  if (count == 0) return;
  const int room = picture.width() / count;
  int left = 0;
  for (const ShadowMap& map : maps) {
    if (map.size == 0) continue;
    const int side =
        std::max(map.cube ? std::min(room / 4, picture.height() / 3) : std::min(room, picture.height()), 1);
    for (std::size_t face = 0; face < map.faces.size(); ++face) {
      const Vec2i cell = map.cube ? cross_cell(static_cast<int>(face)) : Vec2i(0);
      paint(map.faces[face], left + cell.x * side, cell.y * side, side, picture);
    }
    left += room;
  }
}

}  // namespace ps::raster
