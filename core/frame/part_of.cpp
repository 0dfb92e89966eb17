#include <algorithm>
#include <limits>

#include "frame/slow_motion.h"

namespace ps {
namespace {

/// Calls visit(member, its value for the background) for everything that is stored pixel by pixel.
template <class Visit>
void for_each_image(const Vec3d& background, Visit&& visit) {
  visit(&Frame::colour, Vec3f(background));
  visit(&Frame::colour_double, background);
  visit(&Frame::depth, std::numeric_limits<float>::infinity());
  visit(&Frame::normal, Vec3f(0));
  visit(&Frame::barycentric, Vec3f(0));
  visit(&Frame::uv, Vec2f(0));
  visit(&Frame::ids, PixelId{});
  visit(&Frame::facing, 0.0f);
  visit(&Frame::overdraw, 0u);
  visit(&Frame::tests, 0u);
  visit(&Frame::mip, -1.0f);
  visit(&Frame::shadow, 0u);
  visit(&Frame::samples, 0u);
  visit(&Frame::direction, Vec3f(0));
}

}  // namespace

void copy_part(const Frame& from, std::span<const TileRect> done, Frame& to) {
  for_each_image({}, [&](auto image, const auto&) {
    if ((from.*image).empty()) return;
    for (const TileRect& rect : done)
      for (int y = rect.y0; y < rect.y1; ++y)
        std::copy_n((from.*image).row(y).begin() + rect.x0, rect.width(), (to.*image).row(y).begin() + rect.x0);
  });
}

Frame part_of(const Frame& whole, std::span<const TileRect> done, const Vec3d& background) {
  Frame part;
  for_each_image(background, [&](auto image, const auto& empty) {
    using Picture = std::remove_reference_t<decltype(part.*image)>;
    if (!(whole.*image).empty()) part.*image = Picture(whole.width(), whole.height(), empty);
  });
  copy_part(whole, done, part);
  part.shadow_map = whole.shadow_map;
  part.stencil = whole.stencil;
  part.environment = whole.environment;
  part.counters.given = {};
  part.path = whole.path;
  return part;
}

}  // namespace ps
