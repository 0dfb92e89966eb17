#include "render/channel_picture.h"

#include <algorithm>
#include <limits>

#include "image/heat_colour.h"
#include "render/channels/channels.h"

namespace ps {
namespace {

/// Where a number that is counted starts at 0, so should its range; a single value still gives a range.
ValueRange widened(ValueRange range, const HeatMap& heat) {
  if (heat.from_zero) range.low = std::min(range.low, 0.0);
  if (!(range.high > range.low)) range.high = range.low + 1;
  return range;
}

ChannelPicture heat_picture(const Frame& frame, const ShownChannelRow& row, const std::optional<ValueRange>& asked) {
  const HeatMap& heat = row.heat;
  const ValueRange range = asked ? *asked : widened(channel_range(frame, row.channel).value_or(ValueRange{}), heat);
  const double length = range.high > range.low ? range.high - range.low : 1;
  ChannelPicture result;
  result.levels = channels::paint(frame, [&](int x, int y) {
    const auto value = heat.value(frame, x, y);
    return value ? heat_colour((*value - range.low) / length) : channels::nothing_seen;
  });
  result.legend.heat = true;
  result.legend.whole = heat.whole;
  result.legend.low = range.low;
  result.legend.high = range.high;
  if (!heat.without_value.empty()) result.legend.entries = {{channels::nothing_seen, std::string(heat.without_value)}};
  return result;
}

}  // namespace

std::optional<ValueRange> channel_range(const Frame& frame, ShownChannel channel) {
  const HeatMap& heat = shown_channel(channel).heat;
  if (!heat.value) return {};
  std::optional<ValueRange> range;
  for (int y = 0; y < frame.height(); ++y) {
    for (int x = 0; x < frame.width(); ++x) {
      const auto value = heat.value(frame, x, y);
      if (!value) continue;
      if (!range) range = ValueRange{*value, *value};
      range->low = std::min(range->low, *value);
      range->high = std::max(range->high, *value);
    }
  }
  return range && heat.usual ? heat.usual(frame, *range) : range;
}

ChannelPicture channel_picture(const Frame& frame, ShownChannel channel, const Settings& settings,
                               const std::optional<ValueRange>& range) {
  const ShownChannelRow& row = shown_channel(channel);
  ChannelPicture result = row.picture ? row.picture(frame, settings) : heat_picture(frame, row, range);
  result.legend.title = row.label;
  result.legend.unit = row.unit;
  if (row.finish) row.finish(frame, result);
  return result;
}

ChannelFloats channel_floats(const Frame& frame, ShownChannel channel) {
  const ShownChannelRow& row = shown_channel(channel);
  if (row.floats) return row.floats(frame);
  return channels::number_image(frame, [&](int x, int y) {
    return row.heat.value(frame, x, y).value_or(std::numeric_limits<double>::quiet_NaN());
  });
}

std::string channel_value_text(const Frame& frame, ShownChannel channel, const Settings& settings, Vec2i pixel) {
  return shown_channel(channel).text(frame, settings, pixel);
}

}  // namespace ps
