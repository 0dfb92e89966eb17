#include <fmt/format.h>

#include "image/display.h"
#include "render/channels/channels.h"

namespace ps::channels {

std::string triple(const Vec3d& v) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x, v.y, v.z); }

Rgb8 unit_levels(double r, double g, double b) { return display_pixel({r, g, b}, {}); }

Rgb8 dimmed(Rgb8 shown) {
  const auto level = static_cast<std::uint8_t>((shown.r + shown.g + shown.b) / 9);
  return {level, level, level};
}

ChannelLegend legend_of(std::vector<ChannelLegend::Entry> entries) {
  ChannelLegend legend;
  legend.entries = std::move(entries);
  return legend;
}

}  // namespace ps::channels
