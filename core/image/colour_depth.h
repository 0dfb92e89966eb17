#pragma once

namespace ps {

/// Bits of a displayed pixel: 8 for each of three channels, 5-6-5 or 5-5-5.
enum class ColourDepth { bits24, bits16, bits15 };

}  // namespace ps
