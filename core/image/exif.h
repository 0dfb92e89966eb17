#pragma once
#include <string_view>

namespace ps {

/// The first bytes of an EXIF segment of a JPEG file; the block follows.
inline constexpr std::string_view exif_head("Exif\0\0", 6);

/// The orientation that an EXIF block asks for (tag 274 of its first directory, EXIF 2.3): 1 as stored, 2 to 8 mirrored
/// or turned. 1 for a block without it, or one that is damaged.
int exif_orientation(std::string_view block);

}  // namespace ps
