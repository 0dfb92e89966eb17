#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "image/image.h"

namespace ps {

/// The fault of a pixel because of its arithmetic, against the same pixel in double.
enum class PrecisionFault : std::uint8_t {
  none,
  false_hit,     ///< shows an object where double shows the background
  missed_hit,    ///< shows the background where double shows an object
  wrong_winner,  ///< another object or triangle
  shading        ///< the same surface in another colour, by more than one level
};
inline constexpr std::size_t precision_fault_count = 5;
/// For people: "wrong winner".
std::string_view precision_fault_label(PrecisionFault fault);
/// Distinct with any colour vision.
Rgb8 precision_fault_colour(PrecisionFault fault);

}  // namespace ps
