#pragma once
#include <optional>

#include "options/option.h"

namespace ps::hardware {

/// For RendererKind: why the renderer does not act on an option or on a value of it, or nullopt. The option's row says
/// it (HardwareUse). What is honoured, tests/agreement compares with the rasterizer.
std::optional<IdleReason> lacks_option(const Option& option, const Settings& settings);
std::optional<IdleReason> lacks_value(const Option& option, double value, const Settings& settings);

}  // namespace ps::hardware
