#include <fmt/format.h>

#include <array>
#include <utility>

#include "engine/maths_writers.h"

namespace ps {
namespace {

struct SmallSign {
  std::string_view sign, raised, lowered;  ///< empty: there is none
};
constexpr std::array<SmallSign, 17> small_signs{{{"0", "⁰", "₀"},
                                                 {"1", "¹", "₁"},
                                                 {"2", "²", "₂"},
                                                 {"3", "³", "₃"},
                                                 {"4", "⁴", "₄"},
                                                 {"5", "⁵", "₅"},
                                                 {"6", "⁶", "₆"},
                                                 {"7", "⁷", "₇"},
                                                 {"8", "⁸", "₈"},
                                                 {"9", "⁹", "₉"},
                                                 {"+", "⁺", "₊"},
                                                 {"−", "⁻", "₋"},
                                                 {"=", "⁼", "₌"},
                                                 {"(", "⁽", "₍"},
                                                 {")", "⁾", "₎"},
                                                 {"n", "ⁿ", ""},
                                                 {"′", "′", ""}}};

enum class Script { raised, lowered };

/// The text in small characters; empty if not all of it has them.
std::string in_small(std::string_view text, Script script) {
  std::string result;
  while (!text.empty()) {
    std::string_view small;
    std::size_t length = 0;
    for (const SmallSign& each : small_signs)
      if (text.substr(0, each.sign.size()) == each.sign) {
        small = script == Script::raised ? each.raised : each.lowered;
        length = each.sign.size();
      }
    if (small.empty()) return {};
    result += small;
    text.remove_prefix(length);
  }
  return result;
}

/// Whether a row can be read without brackets around it: a sign, a number, a product of letters.
bool holds_together(const MathsRow& row) {
  for (const MathsRole role : roles_in(row))
    if (role != MathsRole::ordinary) return false;
  for (const MathsNode& node : row)
    if (std::holds_alternative<MathsSpace>(node.what) || std::holds_alternative<MathsFraction>(node.what) ||
        std::holds_alternative<MathsWords>(node.what))
      return row.size() == 1 && std::holds_alternative<MathsWords>(node.what);
  return true;
}

std::string bracketed(const MathsRow& row) {
  return holds_together(row) ? plain_maths(row) : fmt::format("({})", plain_maths(row));
}

/// In brackets unless it is one node that needs none; a row of several would be torn apart by what is beside it.
std::string bracketed_if_several(const MathsRow& row) {
  return row.size() == 1 ? bracketed(row) : fmt::format("({})", plain_maths(row));
}

std::string script_text(const MathsRow& row, Script script) {
  if (row.empty()) return {};
  std::string joined;  // no blanks inside a small "n + 1"
  for (const char c : plain_maths(row))
    if (c != ' ') joined += c;
  if (std::string small = in_small(joined, script); !small.empty()) return small;
  return (script == Script::raised ? "^" : "_") + bracketed_if_several(row);
}

struct NodeText {
  std::string operator()(const MathsSign& sign) const { return sign.text; }
  std::string operator()(const MathsGroup& group) const { return plain_maths(group.inside); }
  std::string operator()(const MathsScripts& scripts) const {
    return plain_maths(scripts.base) + script_text(scripts.sub, Script::lowered) +
           script_text(scripts.super, Script::raised);
  }
  std::string operator()(const MathsFraction& fraction) const {
    return fmt::format("{} / {}", bracketed(fraction.numerator), bracketed_if_several(fraction.denominator));
  }
  std::string operator()(const MathsRoot& root) const {
    return fmt::format("{}√{}", script_text(root.degree, Script::raised), bracketed_if_several(root.inside));
  }
  std::string operator()(const MathsAccented& accented) const { return plain_maths(accented.inside); }
  std::string operator()(const MathsFence& fence) const {
    return fence.opening + plain_maths(fence.inside) + fence.closing;
  }
  std::string operator()(const MathsMatrix& matrix) const {
    std::string text;
    for (const auto& row : matrix.rows) {
      if (!text.empty()) text += "; ";
      for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? ", " : "") + plain_maths(row[i]);
    }
    const bool bare = matrix.opening.empty() && matrix.closing.empty();
    return bare ? "[" + text + "]" : matrix.opening + text + matrix.closing;
  }
  std::string operator()(const MathsWords& words) const { return words.text; }
  std::string operator()(const MathsSpace&) const { return " "; }
};

}  // namespace

std::string plain_maths(const MathsRow& row) {
  const std::vector<MathsRole> roles = roles_in(row);
  std::string text;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string node = std::visit(NodeText{}, row[i].what);
    const bool apart = i > 0 && maths_space(roles[i - 1], roles[i], false) > 0;
    if (apart && !text.empty() && text.back() != ' ' && node.substr(0, 1) != " ") text += ' ';
    if (node == " " && (text.empty() || text.back() == ' ')) continue;
    text += node;
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

}  // namespace ps
