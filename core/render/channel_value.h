#pragma once
#include <optional>

#include "render/channel_picture.h"

namespace ps {

/// Whether a channel is shown along heat_colour().
bool is_heat_map(ShownChannel channel);

/// The number that a heat map shows at a pixel; absent where nothing is seen and for other channels.
std::optional<double> heat_value(const Frame& frame, ShownChannel channel, int x, int y);

}  // namespace ps
