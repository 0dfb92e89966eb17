#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "engine/maths_writers.h"
#include "image/svg.h"

namespace ps {
namespace {

std::string element(std::string_view name, std::string_view inside, std::string_view attributes = {}) {
  return fmt::format("<{}{}{}>{}</{}>", name, attributes.empty() ? "" : " ", attributes, inside, name);
}

/// Bold letters and digits have characters of their own; MathML Core knows no bold attribute.
std::string bold_characters(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    unsigned code = 0;
    if (c >= 'A' && c <= 'Z') code = 0x1D400u + byte - 'A';
    if (c >= 'a' && c <= 'z') code = 0x1D41Au + byte - 'a';
    if (c >= '0' && c <= '9') code = 0x1D7CEu + byte - '0';
    if (code == 0) {
      result += c;
      continue;
    }
    for (const int shift : {18, 12, 6, 0})
      result += static_cast<char>((shift == 18 ? 0xF0u : 0x80u) | ((code >> shift) & (shift == 18 ? 0x07u : 0x3Fu)));
  }
  return result;
}

std::string row_markup(const MathsRow& row, bool display);

/// A row as one element, as the parts of fractions and scripts must be.
std::string one_element(const MathsRow& row, bool display) {
  const std::string inside = row_markup(row, display);
  return row.size() == 1 ? inside : element("mrow", inside);
}

std::string delimiter(const std::string& text, std::string_view form) {
  if (text.empty()) return {};
  return element("mo", xml_escaped(text), fmt::format("form=\"{}\" stretchy=\"true\"", form));
}

/// The markup of one node.
struct NodeMarkup {
  bool display;

  std::string operator()(const MathsSign& sign) const {
    const std::string text = xml_escaped(sign.text);
    switch (sign.role) {
    case MathsRole::opening:
    case MathsRole::closing:
      return element("mo", text, "stretchy=\"false\"");
    case MathsRole::binary:
    case MathsRole::relation:
    case MathsRole::punctuation:
      return element("mo", text);
    case MathsRole::function:
      return element(sign.large ? "mo" : "mi", text);
    case MathsRole::ordinary:
      break;
    }
    const auto first = static_cast<unsigned char>(sign.text.front());
    if (std::isdigit(first) != 0) return element("mn", sign.style == MathsStyle::bold ? bold_characters(text) : text);
    if (sign.text == "|" || sign.text == "‖" || sign.text == "/")
      return element("mo", text, "stretchy=\"false\" lspace=\"0\" rspace=\"0\"");
    if (sign.text == "′") return element("mo", text);
    if (sign.style == MathsStyle::bold) return element("mi", bold_characters(text));
    return element("mi", text, sign.style == MathsStyle::upright ? "mathvariant=\"normal\"" : "");
  }
  std::string operator()(const MathsGroup& group) const { return element("mrow", row_markup(group.inside, display)); }
  std::string operator()(const MathsScripts& scripts) const {
    const std::string base = one_element(scripts.base, display);
    const std::string sub = scripts.sub.empty() ? "" : one_element(scripts.sub, false);
    const std::string super = scripts.super.empty() ? "" : one_element(scripts.super, false);
    const auto* sign = std::get_if<MathsSign>(&scripts.base.front().what);
    const bool limits = display && sign && sign->limits;
    const char* name = limits ? (super.empty() ? "munder"
                                 : sub.empty() ? "mover"
                                               : "munderover")
                              : (super.empty() ? "msub"
                                 : sub.empty() ? "msup"
                                               : "msubsup");
    return element(name, base + sub + super);
  }
  std::string operator()(const MathsFraction& fraction) const {
    return element("mfrac", one_element(fraction.numerator, false) + one_element(fraction.denominator, false));
  }
  std::string operator()(const MathsRoot& root) const {
    if (root.degree.empty()) return element("msqrt", row_markup(root.inside, display));
    return element("mroot", one_element(root.inside, display) + one_element(root.degree, false));
  }
  std::string operator()(const MathsAccented& accented) const {
    const char* accent = accented.accent == MathsAccent::vector ? "→" : accented.accent == MathsAccent::hat ? "^" : "¯";
    return element("mover", one_element(accented.inside, display) + element("mo", accent), "accent=\"true\"");
  }
  std::string operator()(const MathsFence& fence) const {
    return element("mrow", delimiter(fence.opening, "prefix") + row_markup(fence.inside, display) +
                               delimiter(fence.closing, "postfix"));
  }
  std::string operator()(const MathsMatrix& matrix) const {
    std::string rows;
    for (const auto& row : matrix.rows) {
      std::string cells;
      for (const MathsRow& cell : row) cells += element("mtd", row_markup(cell, false));
      rows += element("mtr", cells);
    }
    const char* attributes = matrix.alignment == MathsAlignment::left ? "columnalign=\"left\"" : "";
    return element("mrow", delimiter(matrix.opening, "prefix") + element("mtable", rows, attributes) +
                               delimiter(matrix.closing, "postfix"));
  }
  std::string operator()(const MathsWords& words) const { return element("mtext", xml_escaped(words.text)); }
  std::string operator()(const MathsSpace& space) const {
    return fmt::format("<mspace width=\"{:.4g}em\"/>", space.em);
  }
};

std::string row_markup(const MathsRow& row, bool display) {
  std::string result;
  for (const MathsNode& node : row) result += std::visit(NodeMarkup{display}, node.what);
  return result;
}

}  // namespace

std::string mathml(const Formula& formula) {
  const bool display = formula.form == FormulaForm::display;
  return element(
      "math", element("mrow", row_markup(formula.row, display)),
      fmt::format("xmlns=\"http://www.w3.org/1998/Math/MathML\" display=\"{}\"", display ? "block" : "inline"));
}

}  // namespace ps
