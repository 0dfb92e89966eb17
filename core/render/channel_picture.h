#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "frame/frame.h"
#include "options/settings.h"

namespace ps {

/// The value of a frame that a view shows.
enum class ShownChannel {
  colour,
  depth,
  normal,
  barycentric,
  uv,
  triangle,
  object,
  facing,
  overdraw,
  tests,
  mip,
  samples,
  shadow,
  hit,
  direction,
  nan,
  shadow_map,
  stencil,
  environment,
  precision,
  depth_gap,
  field
};

/// The meaning of the colours of a channel picture.
struct ChannelLegend {
  std::string title;
  std::string unit;   ///< of low and high; may be empty
  bool heat = false;  ///< colours run from low to high along heat_colour()
  double low = 0, high = 0;
  bool whole = false;  ///< all values are whole numbers
  struct Entry {
    Rgb8 colour;
    std::string meaning;
    int object = -1;  ///< index into Geometry::objects that the colour represents; -1 = none
  };
  std::vector<Entry> entries;  ///< colours with a meaning of their own, such as "nothing seen"
};

struct ChannelPicture {
  Image<Rgb8> levels;
  ChannelLegend legend;
};

struct ValueRange {
  double low = 0, high = 1;
  bool operator==(const ValueRange&) const = default;
};

/// The numbers of a channel instead of colours: one or three for each pixel.
using ChannelFloats = std::variant<Image<float>, Image<Vec3f>>;

/// How a channel is shown along heat_colour().
struct HeatMap {
  /// The number that is shown at a pixel; absent where there is none.
  std::optional<double> (*value)(const Frame& frame, int x, int y) = nullptr;
  bool from_zero = true;             ///< the range of colours begins at 0, or below; else at the smallest number
  bool whole = false;                ///< all numbers are whole
  std::string_view without_value{};  ///< meaning of pixels without a number
  ValueRange (*usual)(const Frame& frame, ValueRange) = nullptr;  ///< the part of the range that is worth its colours
};

/// All that there is to know about one ShownChannel. The functions take frames that were made with the channels that
/// the row needs.
struct ShownChannelRow {
  ShownChannel channel = ShownChannel::colour;
  std::string_view key;    ///< for `--show` and scripts: "depth"
  std::string_view label;  ///< for people
  std::string_view help;   ///< one sentence
  Channel needs = Channel::none;
  std::string_view unit;  ///< of the value shown as a heat map; may be empty
  /// The value at a pixel as short text.
  std::string (*text)(const Frame& frame, const Settings& settings, Vec2i pixel) = nullptr;
  HeatMap heat{};  ///< without `value`: the channel is not a heat map
  /// Its colours with their legend, without title and unit; nullptr: as a heat map.
  ChannelPicture (*picture)(const Frame& frame, const Settings& settings) = nullptr;
  /// Its numbers; nullptr: those of the heat map, NaN where there is none.
  ChannelFloats (*floats)(const Frame& frame) = nullptr;
  /// Gives the picture a title of its own and marks in it; nullptr: none.
  void (*finish)(const Frame& frame, ChannelPicture& picture) = nullptr;
};
/// One row for each ShownChannel, in its order.
std::span<const ShownChannelRow> shown_channels();
const ShownChannelRow& shown_channel(ShownChannel channel);
/// Throws InputError naming the keys there are.
ShownChannel parse_shown_channel(std::string_view key);

/// Smallest and largest finite value of a heat-map channel in this frame; absent for other channels or where nothing is
/// seen. The union of two frames' ranges makes their pictures comparable.
std::optional<ValueRange> channel_range(const Frame& frame, ShownChannel channel);

/// Turns a channel into a picture. The frame must have been made with the channels that the row needs. Heat maps span
/// `range`, by default the frame's own.
ChannelPicture channel_picture(const Frame& frame, ShownChannel channel, const Settings& settings,
                               const std::optional<ValueRange>& range = {});

/// The values themselves, as Frame describes them; the frame must have been made with the channels that the row needs.
/// Vectors keep their x, y, z; uv has u, v, 0. Of a heat map the number that it shows, NaN where there is none (depth:
/// +infinity). `triangle` and `object` are indices, -1 for the background; `hit` is 0 or 1; `nan` is 0 for finite
/// colours, 1 for NaN, 2 for infinite ones; `precision` is the number of the fault, in the order of PrecisionFault.
ChannelFloats channel_floats(const Frame& frame, ShownChannel channel);

/// The channel's value at a pixel as short text, for a readout: "z 7.25", "object 2", "(0.1, 0.9)".
std::string channel_value_text(const Frame& frame, ShownChannel channel, const Settings& settings, Vec2i pixel);

}  // namespace ps
