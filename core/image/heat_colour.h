#pragma once
#include "image/image.h"

namespace ps {

/// Cividis (Nuñez, Anderton and Renslow 2018): from dark blue to yellow, lightness rising evenly, readable with any
/// colour vision. `t` in [0, 1]; values outside are clamped, NaN gives the lower end.
Rgb8 heat_colour(double t);

/// A colour for a whole number: the same number always has the same colour, and neighbours differ clearly. Never black
/// and never white.
Rgb8 id_colour(std::uint32_t id);

}  // namespace ps
