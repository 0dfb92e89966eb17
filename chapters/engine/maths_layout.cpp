#include "engine/maths_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/maths_shapes.h"

namespace ps {
namespace {

// Shares of the em of the text, after The TeXbook, appendix G, for a sans serif font.
constexpr float least_raise = 0.38f, least_drop = 0.18f;          // baselines of scripts
constexpr float raise_below_top = 0.3f, drop_above_foot = 0.08f;  // the same for a high base, from its edges
constexpr float script_gap = 0.03f, scripts_apart = 0.2f;
constexpr float fraction_gap = 0.14f, fraction_edge = 0.1f, fraction_up = 0.66f, fraction_down = 0.66f;
constexpr float root_gap = 0.12f, accent_gap = 0.1f, slant = 0.07f;
constexpr float limit_gap = 0.2f;
constexpr float inner_space = 3.0f / 18, delimiter_gap = 0.08f;
constexpr float delimiter_in_font = 0.62f;  // up to this reach from the axis, the font's own delimiter does
constexpr float column_gap = 0.9f, row_gap = 0.3f, line_of_row = 1.25f;

enum class Setting { in_text, displayed };

struct SetStyle {
  Setting setting = Setting::in_text;
  MathsSize size = MathsSize::text;

  SetStyle script() const { return {Setting::in_text, MathsSize::script}; }
  SetStyle cell() const { return {Setting::in_text, size}; }
};

float whole(float length) { return std::round(length); }

/// Has edges of its own, such as a bar or high delimiters, from which its neighbours keep away.
bool is_inner(const MathsNode& node) {
  return std::holds_alternative<MathsFraction>(node.what) || std::holds_alternative<MathsFence>(node.what) ||
         std::holds_alternative<MathsMatrix>(node.what);
}

/// Between a node and the one before it, in em.
float space_before(const MathsRow& nodes, const std::vector<MathsRole>& roles, std::size_t i, SetStyle style) {
  const bool script = style.size == MathsSize::script;
  const auto space = static_cast<float>(maths_space(roles[i - 1], roles[i], script));
  if (space > 0 || script || (!is_inner(nodes[i - 1]) && !is_inner(nodes[i]))) return space;
  const auto takes_none = [](const MathsNode& node) { return std::holds_alternative<MathsSpace>(node.what); };
  const bool at_edge = roles[i - 1] == MathsRole::opening || roles[i] == MathsRole::closing;
  const bool operators = roles[i - 1] == MathsRole::relation || roles[i] == MathsRole::relation;
  return at_edge || operators || takes_none(nodes[i - 1]) || takes_none(nodes[i]) ? 0 : inner_space;
}

/// Primes are high already: they are neither raised nor made smaller.
bool primes_alone(const MathsRow& row) {
  return !row.empty() && std::all_of(row.begin(), row.end(), [](const MathsNode& node) {
    const auto* sign = std::get_if<MathsSign>(&node.what);
    return sign && sign->text == "′";
  });
}

class MathsSetter {
 public:
  explicit MathsSetter(const MathsFont& font) : font_(font), rule_(maths_rule(font)) {}

  MathsBox row(const MathsRow& nodes, const std::vector<MathsRole>& roles, std::size_t begin, std::size_t end,
               SetStyle style) const {
    MathsBox box;
    for (std::size_t i = begin; i < end; ++i) {
      if (i > begin) box.width += font_.em(style.size) * space_before(nodes, roles, i, style);
      const MathsBox next = node(nodes[i], style);
      box.add(next, box.width);
      box.width += next.width;
    }
    return box;
  }

  MathsBox row(const MathsRow& nodes, SetStyle style) const {
    return row(nodes, roles_in(nodes), 0, nodes.size(), style);
  }

 private:
  MathsBox node(const MathsNode& node, SetStyle style) const {
    return std::visit([&](const auto& what) { return set(what, style); }, node.what);
  }

  float em(SetStyle style) const { return font_.em(style.size); }
  float axis(SetStyle style) const { return maths_axis(font_, style.size); }

  MathsBox text(const std::string& words, MathsStyle face, SetStyle style) const {
    const InkBox ink = font_.ink(face, style.size, words);
    return {ink.advance, std::max(0.0f, ink.above), std::max(0.0f, ink.below), {{0, 0, words, face, style.size}}, {},
            {}};
  }

  MathsBox set(const MathsSign& sign, SetStyle style) const {
    if (sign.large && style.setting == Setting::displayed) return drawn_operator(sign.text, em(style), axis(style));
    if (always_drawn(sign.text)) {
      const float reach = 0.5f * em(style);
      const auto end = sign.role == MathsRole::opening ? DelimiterEnd::opening : DelimiterEnd::closing;
      return drawn_delimiter(sign.text, end, em(style), axis(style) + reach, reach - axis(style));
    }
    return text(sign.text, sign.style, style);
  }

  MathsBox set(const MathsGroup& group, SetStyle style) const { return row(group.inside, style); }
  MathsBox set(const MathsWords& words, SetStyle style) const { return text(words.text, MathsStyle::upright, style); }

  MathsBox set(const MathsSpace& space, SetStyle style) const {
    MathsBox box;
    box.width = em(style) * static_cast<float>(space.em);
    return box;
  }

  /// How far a superscript must move to the right of a slanted letter, whose top leans there.
  float overhang(const MathsSign& sign, SetStyle style) const {
    const InkBox ink = font_.ink(sign.style, style.size, sign.text);
    return std::clamp(ink.right - ink.advance + slant * em(style), 0.0f, 2 * slant * em(style));
  }

  MathsBox set(const MathsScripts& scripts, SetStyle style) const {
    const auto* sign = std::get_if<MathsSign>(&scripts.base.front().what);
    if (sign && sign->limits && style.setting == Setting::displayed) return with_limits(scripts, style);
    const float e = em(style);
    MathsBox box = row(scripts.base, style);
    const bool primes = primes_alone(scripts.super);
    const MathsBox sub = row(scripts.sub, style.script()),
                   super = row(scripts.super, primes ? style.cell() : style.script());
    const bool high = !sign || (sign->large && style.setting == Setting::displayed);
    float raise = least_raise * e, drop = least_drop * e;
    if (high) {
      raise = std::max(raise, box.above - raise_below_top * e);
      drop = std::max(drop, box.below + drop_above_foot * e);
    }
    raise = primes && !high ? 0 : whole(std::max(raise, super.below + 0.25f * e));
    drop = whole(drop);
    if (!scripts.sub.empty() && !scripts.super.empty() && !primes)
      drop = std::max(drop, whole(sub.above - (raise - super.below) + scripts_apart * e));
    const float lean = sign && sign->style == MathsStyle::italic ? overhang(*sign, style) : 0;
    const float x = box.width + script_gap * e;
    if (!scripts.super.empty()) box.add(super, x + lean, -raise);
    if (!scripts.sub.empty()) box.add(sub, x, drop);
    box.width = x + std::max(scripts.super.empty() ? 0 : super.width + lean, sub.width);
    return box;
  }

  MathsBox with_limits(const MathsScripts& scripts, SetStyle style) const {
    const MathsBox base = row(scripts.base, style), sub = row(scripts.sub, style.script()),
                   super = row(scripts.super, style.script());
    MathsBox box;
    box.width = std::max({base.width, sub.width, super.width});
    const auto centred = [&](const MathsBox& part) { return (box.width - part.width) / 2; };
    const float gap = limit_gap * em(style);
    box.add(base, centred(base));
    if (!scripts.super.empty()) box.add(super, centred(super), -whole(base.above + gap + super.below));
    if (!scripts.sub.empty()) box.add(sub, centred(sub), whole(base.below + gap + sub.above));
    return box;
  }

  MathsBox set(const MathsFraction& fraction, SetStyle style) const {
    const SetStyle inside = style.setting == Setting::displayed ? style.cell() : style.script();
    const MathsBox top = row(fraction.numerator, inside), bottom = row(fraction.denominator, inside);
    const float e = em(style), part = em(inside) / e;
    const float gap = std::max(2.0f, fraction_gap * e * part);
    // The bar lies on whole pixels, with the axis in its middle as nearly as that allows.
    const float bar = -whole(axis(style) + rule_ / 2);
    const float up = whole(std::max(-bar + gap + top.below, fraction_up * e * part));
    const float down = whole(std::max(bar + rule_ + gap + bottom.above, fraction_down * e * part));
    MathsBox box;
    const float width = std::max(top.width, bottom.width), edge = fraction_edge * e;
    box.add(top, edge + (width - top.width) / 2, -up);
    box.add(bottom, edge + (width - bottom.width) / 2, down);
    box.rules.push_back({edge / 2, bar, width + edge, rule_});
    box.width = width + 2 * edge;
    return box;
  }

  MathsBox set(const MathsRoot& root, SetStyle style) const {
    const float e = em(style);
    const MathsBox inside = row(root.inside, style);
    const float above = whole(std::max(inside.above, 0.6f * e) + root_gap * e + rule_),
                below = whole(inside.below + 0.06f * e);
    const MathsBox radical = drawn_radical(e, above, below);
    MathsBox box;
    float x = 0;
    if (!root.degree.empty()) {
      const MathsBox degree = row(root.degree, style.script());
      x = std::max(0.0f, degree.width - 0.2f * e);
      box.add(degree, std::max(0.0f, 0.2f * e - degree.width),
              -whole(std::max(0.1f * e, above - below) * 0.5f + 0.12f * e));
    }
    box.add(radical, x);
    x += radical.width;
    box.rules.push_back({x, -above, inside.width + 0.06f * e, rule_});
    box.add(inside, x);
    box.width = x + inside.width + 0.1f * e;
    return box;
  }

  MathsBox set(const MathsAccented& accented, SetStyle style) const {
    const float e = em(style);
    MathsBox box = row(accented.inside, style);
    const auto* sign = std::get_if<MathsSign>(&accented.inside.front().what);
    const float lean = sign && accented.inside.size() == 1 && sign->style == MathsStyle::italic ? slant * e : 0;
    const float edge = 0.06f * e, width = std::max(box.width - 2 * edge, 0.4f * e);
    const MathsBox accent = drawn_accent(accented.accent, e, width, rule_);
    const float x = (box.width - width) / 2 + lean;
    box.add(accent, x, -whole(box.above + accent_gap * e));
    box.width = std::max(box.width, x + width);
    return box;
  }

  /// Puts delimiters of its height around a box.
  MathsBox fenced(const std::string& opening, const std::string& closing, const MathsBox& inside,
                  SetStyle style) const {
    const float e = em(style), a = axis(style);
    const float reach = std::max({inside.above - a, inside.below + a, 0.0f}) + 0.04f * e;
    const auto delimiter = [&](const std::string& sign, DelimiterEnd end) -> MathsBox {
      if (sign.empty()) return {};
      if (reach <= delimiter_in_font * e && !always_drawn(sign)) return text(sign, MathsStyle::upright, style);
      return drawn_delimiter(sign, end, e, whole(a + reach), whole(reach - a));
    };
    const MathsBox left = delimiter(opening, DelimiterEnd::opening), right = delimiter(closing, DelimiterEnd::closing);
    const float gap = reach > delimiter_in_font * e ? delimiter_gap * e : 0;
    MathsBox box;
    box.add(left, 0);
    box.add(inside, left.width + gap);
    box.add(right, left.width + inside.width + 2 * gap);
    box.width = left.width + inside.width + right.width + 2 * gap;
    return box;
  }

  MathsBox set(const MathsFence& fence, SetStyle style) const {
    return fenced(fence.opening, fence.closing, row(fence.inside, style), style);
  }

  MathsBox set(const MathsMatrix& matrix, SetStyle style) const {
    const float e = em(style);
    std::vector<std::vector<MathsBox>> cells;
    std::vector<float> widths(matrix.rows.front().size(), 0.0f), baselines;
    float y = 0, below = 0;
    for (const auto& line : matrix.rows) {
      auto& boxes = cells.emplace_back();
      float above = 0, next_below = 0;
      for (std::size_t i = 0; i < line.size(); ++i) {
        boxes.push_back(row(line[i], style.cell()));
        widths[i] = std::max(widths[i], boxes.back().width);
        above = std::max(above, boxes.back().above);
        next_below = std::max(next_below, boxes.back().below);
      }
      if (!baselines.empty()) y += whole(std::max(line_of_row * e, below + row_gap * e + above));
      baselines.push_back(y);
      below = next_below;
    }
    MathsBox inside;
    for (std::size_t r = 0; r < cells.size(); ++r) {
      float x = 0;
      for (std::size_t i = 0; i < cells[r].size(); ++i) {
        const float free = widths[i] - cells[r][i].width;
        inside.add(cells[r][i], x + (matrix.alignment == MathsAlignment::left ? 0 : free / 2), baselines[r]);
        x += widths[i] + column_gap * e;
      }
      inside.width = x - column_gap * e;
    }
    const float shift = whole((inside.above - inside.below) / 2 - axis(style));
    MathsBox centred;
    centred.add(inside, 0, shift);
    centred.width = inside.width;
    return fenced(matrix.opening, matrix.closing, centred, style);
  }

  const MathsFont& font_;
  float rule_;
};

/// Where a line may end, from the best place on.
enum class Break { never, binary, relation, wide_space };

Break break_behind(const MathsRow& row, const std::vector<MathsRole>& roles, std::size_t i) {
  if (i + 1 >= row.size()) return Break::never;
  const auto* space = std::get_if<MathsSpace>(&row[i].what);
  if (space && space->em >= 1) return Break::wide_space;
  if (roles[i] == MathsRole::relation && roles[i + 1] != MathsRole::relation) return Break::relation;
  return roles[i] == MathsRole::binary ? Break::binary : Break::never;
}

/// The ends of the parts into which a row from `begin` to `end` is divided at breaks of at least this kind.
std::vector<std::size_t> ends_of_parts(const MathsRow& row, const std::vector<MathsRole>& roles, std::size_t begin,
                                       std::size_t end, Break least) {
  std::vector<std::size_t> ends;
  for (std::size_t i = begin; i + 1 < end; ++i)
    if (break_behind(row, roles, i) >= least) ends.push_back(i + 1);
  ends.push_back(end);
  return ends;
}

/// Without wide spaces at its ends.
MathsBox trimmed_part(const MathsSetter& layout, const MathsRow& row, const std::vector<MathsRole>& roles,
                      std::size_t begin, std::size_t end, SetStyle style) {
  const auto is_space = [&](std::size_t i) { return std::holds_alternative<MathsSpace>(row[i].what); };
  while (end > begin + 1 && is_space(end - 1)) --end;
  return layout.row(row, roles, begin, end, style);
}

}  // namespace

void MathsBox::add(const MathsBox& other, float x, float y) {
  above = std::max(above, other.above - y);
  below = std::max(below, other.below + y);
  for (MathsText text : other.texts) {
    text.x += x;
    text.y += y;
    texts.push_back(std::move(text));
  }
  for (MathsStroke stroke : other.strokes) {
    for (MathsPoint& point : stroke.points) {
      point.x += x;
      point.y += y;
    }
    strokes.push_back(std::move(stroke));
  }
  for (MathsRule rule : other.rules) {
    rule.x += x;
    rule.y += y;
    above = std::max(above, -rule.y);
    rules.push_back(rule);
  }
}

float maths_axis(const MathsFont& font, MathsSize size) {
  const InkBox minus = font.ink(MathsStyle::upright, size, "−");
  return (minus.above - minus.below) / 2;
}

float maths_rule(const MathsFont& font) { return std::max(1.0f, std::round(0.06f * font.em(MathsSize::text))); }

std::vector<MathsBox> set_in_text(const Formula& formula, const MathsFont& font, float width) {
  const MathsSetter layout(font);
  const std::vector<MathsRole> roles = roles_in(formula.row);
  std::vector<MathsBox> boxes;
  std::size_t begin = 0;
  for (const std::size_t end : ends_of_parts(formula.row, roles, 0, formula.row.size(), Break::relation)) {
    MathsBox box = trimmed_part(layout, formula.row, roles, begin, end, {});
    if (box.width <= width) {
      boxes.push_back(std::move(box));
    } else {
      std::size_t from = begin;
      for (const std::size_t to : ends_of_parts(formula.row, roles, begin, end, Break::binary)) {
        boxes.push_back(trimmed_part(layout, formula.row, roles, from, to, {}));
        from = to;
      }
    }
    begin = end;
  }
  return boxes;
}

std::vector<MathsBox> set_displayed(const Formula& formula, const MathsFont& font, float width) {
  const MathsSetter layout(font);
  const SetStyle style{Setting::displayed, MathsSize::text};
  const MathsRow& row = formula.row;
  const std::vector<MathsRole> roles = roles_in(row);
  std::vector<MathsBox> lines;
  for (std::size_t begin = 0; begin < row.size();) {
    // The longest line that fits; of the places where it may end, the best kind that fits at all.
    std::size_t next = row.size();
    MathsBox line = trimmed_part(layout, row, roles, begin, next, style);
    for (const Break least : {Break::wide_space, Break::relation, Break::binary}) {
      if (line.width <= width) break;
      for (const std::size_t end : ends_of_parts(row, roles, begin, row.size(), least)) {
        MathsBox part = trimmed_part(layout, row, roles, begin, end, style);
        if (part.width > width && least != Break::binary) break;
        const bool first = next == row.size();
        if (part.width > width && !first) break;
        next = end;
        line = std::move(part);
        if (line.width > width) break;
      }
    }
    lines.push_back(std::move(line));
    begin = next;
  }
  return lines;
}

}  // namespace ps
