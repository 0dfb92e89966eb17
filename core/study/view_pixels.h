#pragma once
#include "frame/view.h"

namespace ps {

/// Number of pixels of a picture, as a factor of times and counts.
inline double pixels_of(const View& view) { return static_cast<double>(view.width) * view.height; }

}  // namespace ps
