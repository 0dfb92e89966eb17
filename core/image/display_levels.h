#pragma once
#include <cstddef>
#include <cstdint>

namespace ps {

/// Display levels of single channels without a curve, 24-bit: value * exposure * 255 in double, clamped to [0, 255]
/// (NaN gives 0) and rounded, half to even. Many at once (Highway), with the bits of display_pixel.
void display_levels(const float* values, std::size_t count, double exposure, std::uint8_t* levels);

}  // namespace ps
