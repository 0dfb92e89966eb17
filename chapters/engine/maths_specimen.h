#pragma once
#include <string_view>

namespace ps {

/// A text in the form of a lesson's step that uses every construct and every command of the notation of formulas, for
/// tests and for the eye. A test requires that none is missing.
std::string_view maths_specimen();

}  // namespace ps
