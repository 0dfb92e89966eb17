#pragma once
#include <vector>

#include "engine/maths_box.h"

namespace ps {

/// A formula in a text as boxes side by side with the space of a word between them: lines may end there,
/// which is behind relations, and where a part is wider than `width`, behind binary signs.
std::vector<MathsBox> set_in_text(const Formula& formula, const MathsFont& font, float width);

/// A formula on lines of its own: one box for each. It is parted behind relations, at wide spaces and behind binary
/// signs where it is wider than `width`.
std::vector<MathsBox> set_displayed(const Formula& formula, const MathsFont& font, float width);

/// Height of the line on which fractions and signs such as + are centred, above the baseline.
float maths_axis(const MathsFont& font, MathsSize size);

/// Thickness of bars: whole pixels.
float maths_rule(const MathsFont& font);

}  // namespace ps
