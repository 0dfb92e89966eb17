#pragma once
#include "math/power.h"

namespace ps {

/// No cosine up to this one is 2^-38 or more when it is raised to `exponent`. Beside a light that is not dark such a
/// highlight is lost in rounding.
inline float faint_cosine(float exponent) { return 0.999f * power(2.0f, -38.0f / exponent); }

}  // namespace ps
