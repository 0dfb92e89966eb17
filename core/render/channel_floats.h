#pragma once
#include <variant>

#include "render/channel_picture.h"

namespace ps {

/// The numbers of a channel instead of colours: one or three for each pixel.
using ChannelFloats = std::variant<Image<float>, Image<Vec3f>>;

/// The values themselves, as Frame describes them; the frame must have been made with the channels that the row needs.
/// Vectors keep their x, y, z; uv has u, v, 0. Of a heat map the number that it shows, NaN where there is none (depth:
/// +infinity). `triangle` and `object` are indices, -1 where nothing is seen; `hit` is 0 or 1; `nan` is 0 for finite
/// colours, 1 for NaN, 2 for infinite ones; `precision` is the number of the fault, in the order of PrecisionFault.
ChannelFloats channel_floats(const Frame& frame, ShownChannel channel);

}  // namespace ps
