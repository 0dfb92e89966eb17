#pragma once
#include <string>

#include "base/parallel.h"

namespace ps::cli {

/// Reads "X,Y,W,H" in pixels. Throws InputError for anything else and for an empty rectangle.
TileRect parse_region(const std::string& text);

}  // namespace ps::cli
