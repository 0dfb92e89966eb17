#include "inspect/microscope/texels.h"

#include <algorithm>
#include <cmath>

#include "image/display.h"
#include "image/texture_sampling.h"

namespace ps {
namespace {

constexpr int least_reach = 2, most_reach = 8;  // texels shown to each side of the lookup

/// The texel that is at a place beyond the borders.
int texel_at(int x, int size, TextureWrap wrap) {
  const auto modulo = [](int value, int by) { return ((value % by) + by) % by; };
  switch (wrap) {
  case TextureWrap::repeat:
    return modulo(x, size);
  case TextureWrap::clamp:
    return std::clamp(x, 0, size - 1);
  case TextureWrap::mirror: {
    const int around = modulo(x, 2 * size);
    return around < size ? around : 2 * size - 1 - around;
  }
  }
  return 0;
}

MicroTexels around(const Image<Vec3f>& image, int level, const Vec2d& uv, TextureWrap wrap,
                   const std::optional<std::array<Vec2d, 2>>& steps) {
  MicroTexels out;
  out.level = level;
  out.place = {wrap_coordinate(uv.x, wrap) * image.width(), wrap_coordinate(uv.y, wrap) * image.height()};
  int reach = least_reach;
  if (steps) {
    const double shrink = std::ldexp(1.0, -level);
    const Vec2d right = (*steps)[0] * shrink, down = (*steps)[1] * shrink;
    for (const Vec2d& corner : {Vec2d(-1, -1), Vec2d(1, -1), Vec2d(1, 1), Vec2d(-1, 1)})
      out.footprint.push_back(out.place + (right * corner.x + down * corner.y) / 2.0);
    const double span = std::max(std::abs(right.x) + std::abs(down.x), std::abs(right.y) + std::abs(down.y)) / 2;
    if (span < most_reach) reach = std::max(reach, static_cast<int>(std::ceil(span)) + 1);
    if (!(span < most_reach)) reach = most_reach;
    reach = std::min(reach, most_reach);
  }
  out.x0 = static_cast<int>(std::floor(out.place.x - 0.5)) - reach + 1;
  out.y0 = static_cast<int>(std::floor(out.place.y - 0.5)) - reach + 1;
  out.texels = Image<Rgb8>(2 * reach, 2 * reach);
  for (int y = 0; y < 2 * reach; ++y)
    for (int x = 0; x < 2 * reach; ++x)
      out.texels.at(x, y) = display_pixel(
          Vec3d(image.at(texel_at(out.x0 + x, image.width(), wrap), texel_at(out.y0 + y, image.height(), wrap))), {});
  return out;
}

/// Where texel `x` is nearest to the place that was read, going around as the wrapping asks.
int nearest_copy(int x, int size, double place, TextureWrap wrap) {
  int best = x;
  if (wrap != TextureWrap::repeat) return best;
  for (const int other : {x - size, x + size})
    if (std::abs(other + 0.5 - place) < std::abs(best + 0.5 - place)) best = other;
  return best;
}

}  // namespace

MicroTexture micro_texture(const TextureEvent& lookup, const MipChain& chain, TextureWrap wrap,
                           const std::optional<std::array<Vec2d, 2>>& steps) {
  MicroTexture out{lookup, {}};
  for (const Texel& texel : lookup.texels) {
    if (texel.level < 0 || texel.level >= chain.levels()) continue;
    const Image<Vec3f>& image = chain.level(texel.level);
    auto found = std::find_if(out.levels.begin(), out.levels.end(),
                              [&](const MicroTexels& texels) { return texels.level == texel.level; });
    if (found == out.levels.end()) found = out.levels.insert(found, around(image, texel.level, lookup.uv, wrap, steps));
    const int x = nearest_copy(texel.x, image.width(), found->place.x, wrap);
    const int y = nearest_copy(texel.y, image.height(), found->place.y, wrap);
    const auto same = std::find_if(found->taps.begin(), found->taps.end(),
                                   [&](const MicroTexels::Tap& tap) { return tap.x == x && tap.y == y; });
    if (same != found->taps.end())
      same->weight += texel.weight;  // several taps of one footprint, or both neighbours at a border
    else
      found->taps.push_back({x, y, texel.weight});
  }
  return out;
}

}  // namespace ps
