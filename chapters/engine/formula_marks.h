#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/check.h"
#include "engine/maths.h"

namespace ps {

/// A formula in a text with marks: from its first dollar sign to behind its last one, in bytes.
struct FormulaMark {
  std::size_t begin = 0, end = 0;
  FormulaForm form = FormulaForm::in_text;

  std::size_t sign_length() const { return form == FormulaForm::display ? 2 : 1; }
  std::string_view notation(std::string_view text) const {
    return text.substr(begin + sign_length(), end - begin - 2 * sign_length());
  }
};

/// Finds $...$ and $$...$$ outside `code`; \$ is not a mark. Throws InputError for a mark without its partner in the
/// same paragraph, and for a control character that hide_formulas() uses. `start` is where the text begins.
std::vector<FormulaMark> find_formulas(std::string_view text, const SourcePlace& start);

/// Replaces each byte of a formula while the text around it is read: CommonMark would take backslashes, stars and
/// brackets in it for its own.
inline constexpr char hidden_byte = '\x01';

/// The text with hidden_byte for each byte of a formula, line ends too, so that all other bytes keep their places.
std::string hide_formulas(std::string_view text, const std::vector<FormulaMark>& formulas);

}  // namespace ps
