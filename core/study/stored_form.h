#pragma once
#include "frame/frame.h"
#include "options/settings.h"

namespace ps {

/// How colours from 0 to 1 become the 256 levels of a file.
enum class StoredRounding {
  nearest,     ///< round(255 v), ties to even: display_frame()
  truncated,   ///< floor(255 v)
  half_up,     ///< floor(255 v + 0.5)
  of_256,      ///< floor(256 v), and 255 for 1
  wrapped,     ///< floor(255 v) without a clamp: 256 is stored as 0
  srgb_curve,  ///< round(255 c) with the curve of sRGB (IEC 61966-2-1)
};

/// Ways in which a program may store a finished picture. Applied in this order: levels, channels, rows
/// and columns, place.
struct StoredForm {
  StoredRounding rounding = StoredRounding::nearest;
  bool red_as_blue = false;
  bool upside_down = false;
  bool mirrored = false;
  Vec2i shift{0, 0};  ///< pixels to the right and down; what comes in at the borders is black
  bool operator==(const StoredForm&) const = default;
};

/// The levels of the frame as such a file has them.
Image<Rgb8> stored_levels(const Frame& frame, const Settings& settings, const StoredForm& form);

}  // namespace ps
