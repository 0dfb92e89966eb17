#include <array>

#include <fmt/format.h>

#include "base/check.h"
#include "render/channels/channels.h"

namespace ps {

std::span<const ShownChannelRow> shown_channels() {
  using namespace channels;
  static const std::array rows{colour_channel,     depth_channel,    normal_channel,      barycentric_channel,
                               uv_channel,         triangle_channel, object_channel,      facing_channel,
                               overdraw_channel,   tests_channel,    mip_channel,         samples_channel,
                               shadow_channel,     hit_channel,      direction_channel,   nan_channel,
                               shadow_map_channel, stencil_channel,  environment_channel, precision_channel,
                               depth_gap_channel,  field_channel};
  return rows;
}

const ShownChannelRow& shown_channel(ShownChannel channel) {
  const ShownChannelRow& row = shown_channels()[static_cast<std::size_t>(channel)];
  PS_ASSERT(row.channel == channel, "rows are in the order of the enum");
  return row;
}

ShownChannel parse_shown_channel(std::string_view key) {
  std::string keys;
  for (const ShownChannelRow& row : shown_channels()) {
    if (row.key == key) return row.channel;
    keys += keys.empty() ? "" : " ";
    keys += row.key;
  }
  throw InputError(fmt::format("show: found \"{}\", expected one of: {}", key, keys));
}

}  // namespace ps
