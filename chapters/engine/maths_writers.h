#pragma once
#include <string>
#include <string_view>

#include "engine/maths.h"

namespace ps {

/// A <math> element in MathML Core with its namespace, for HTML and XML: well-formed, in one line, in ASCII markup with
/// UTF-8 text.
std::string mathml(const Formula& formula);

/// In one line of text, for terminals, searches and labels: "x² + y² = r²", "(a + b) / 2", "√(b² − 4ac)". Accents are
/// left out.
std::string plain_maths(const MathsRow& row);
inline std::string plain_maths(const Formula& formula) { return plain_maths(formula.row); }

}  // namespace ps
