#pragma once
#include <string_view>

#include "engine/maths_box.h"

namespace ps {

enum class DelimiterEnd { opening, closing };

/// A delimiter drawn with lines, from `above` the baseline to `below` it; empty for one that is not known.
MathsBox drawn_delimiter(std::string_view delimiter, DelimiterEnd end, float em, float above, float below);

/// Whether a delimiter is drawn even at the height of a letter: the window's fonts have it only as wide as a digit, or
/// without any space beside it.
bool always_drawn(std::string_view delimiter);

/// The large form of a sum, product or integral, centred on `axis` above the baseline; empty for other signs.
MathsBox drawn_operator(std::string_view sign, float em, float axis);

/// The sign of a root from `above` the baseline to `below`; its right end is where the bar begins.
MathsBox drawn_radical(float em, float above, float below);

/// An accent of this width whose lower edge is at y = 0.
MathsBox drawn_accent(MathsAccent accent, float em, float width, float rule);

}  // namespace ps
