#pragma once
#include <optional>
#include <span>
#include <string_view>

#include "options/option.h"

namespace ps::hardware {

/// An option that the renderer does not act on, or values of it.
struct Lack {
  std::string_view option;  ///< its key
  std::string_view reason;  ///< "the driver has its own coverage test"
  /// The values that it lacks; nullptr: it does not use the option at all.
  bool (*values)(OptionNumber) = nullptr;
};

/// All of them. What is not here is honoured, and tests/agreement compares it with the rasterizer.
std::span<const Lack> lacks();

/// For RendererKind: the reason of an option or of a value, or nothing.
std::optional<IdleReason> lacks_option(const Option& option, const Settings& settings);
std::optional<IdleReason> lacks_value(const Option& option, double value, const Settings& settings);

}  // namespace ps::hardware
