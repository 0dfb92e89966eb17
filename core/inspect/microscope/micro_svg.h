#pragma once
#include <string>

#include "inspect/microscope/drawing.h"

namespace ps {

/// The microscope's view as an SVG file: the pixel at the left, numbers and texels at the right.
std::string micro_svg(const Microscope& microscope, const MicroReading& reading, int selected = -1);

}  // namespace ps
