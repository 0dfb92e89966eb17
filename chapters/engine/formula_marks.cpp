#include "engine/formula_marks.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/place_in_text.h"

namespace ps {
namespace {

constexpr std::size_t most_formulas = 1000;  // a page shows some dozens, and all of them are laid out at once

/// Where the code that begins with the backticks at `at` ends; behind these alone if none close it.
std::size_t end_of_code(std::string_view text, std::size_t at) {
  const std::size_t begin = std::min(text.find_first_not_of('`', at), text.size());
  const std::size_t length = begin - at;
  for (std::size_t from = text.find('`', begin); from != std::string_view::npos;) {
    const std::size_t to = std::min(text.find_first_not_of('`', from), text.size());
    if (to - from == length) return to;
    from = text.find('`', to);
  }
  return begin;
}

bool blank_line_at(std::string_view text, std::size_t newline) {
  const std::size_t next = text.find_first_not_of(" \t\r", newline + 1);
  return next == std::string_view::npos || text[next] == '\n';
}

bool begins_with_quote(std::string_view text, std::size_t at) {
  const std::size_t newline = text.substr(0, at).rfind('\n');
  const std::size_t first = text.find_first_not_of(" \t", newline == std::string_view::npos ? 0 : newline + 1);
  return first != std::string_view::npos && text[first] == '>';
}

/// The closing sign of a formula that begins behind `from`; npos if its paragraph ends before.
std::size_t find_closing(std::string_view text, std::size_t from, std::string_view sign) {
  for (std::size_t i = from; i < text.size(); ++i) {
    if (text[i] == '\\')
      ++i;
    else if (text[i] == '\n' && blank_line_at(text, i))
      return std::string_view::npos;
    else if (text.substr(i, sign.size()) == sign)
      return i;
  }
  return std::string_view::npos;
}

}  // namespace

std::vector<FormulaMark> find_formulas(std::string_view text, const SourcePlace& start) {
  if (const std::size_t at = text.find(hidden_byte); at != std::string_view::npos)
    throw InputError(place_in(text, at, start), "a control character", "text");
  std::vector<FormulaMark> formulas;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '`') {
      i = end_of_code(text, i);
    } else if (text[i] == '\\') {
      i += 2;
    } else if (text[i] != '$') {
      ++i;
    } else {
      const std::string_view sign = text.substr(i, 2) == "$$" ? "$$" : "$";
      const std::size_t closing = find_closing(text, i + sign.size(), sign);
      if (closing == std::string_view::npos)
        throw InputError(place_in(text, i, start), fmt::format("'{}' without its partner", sign),
                         "'\\$' for the sign itself");
      const FormulaMark mark{i, closing + sign.size(), sign == "$" ? FormulaForm::in_text : FormulaForm::display};
      if (begins_with_quote(text, i) && text.substr(i, closing - i).find('\n') != std::string_view::npos)
        throw InputError(place_in(text, i, start), "a formula over several lines in a hint", "one line");
      if (formulas.size() == most_formulas)
        throw InputError(place_in(text, i, start), fmt::format("more than {} formulas in a step", most_formulas),
                         "several steps");
      formulas.push_back(mark);
      i = mark.end;
    }
  }
  return formulas;
}

std::string hide_formulas(std::string_view text, const std::vector<FormulaMark>& formulas) {
  std::string hidden(text);
  for (const FormulaMark& mark : formulas)
    std::fill(hidden.begin() + static_cast<std::ptrdiff_t>(mark.begin),
              hidden.begin() + static_cast<std::ptrdiff_t>(mark.end), hidden_byte);
  return hidden;
}

}  // namespace ps
