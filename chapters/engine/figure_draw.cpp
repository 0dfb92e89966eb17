#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/figure_shapes.h"
#include "engine/formula_marks.h"
#include "engine/maths_layout.h"
#include "engine/place_in_text.h"
#include "image/svg.h"

namespace ps {
namespace {

constexpr double tip_length = 9, tip_width = 7, dot_radius = 3.5, label_gap = 5, figure_edge = 3;  // pixels at scale 1
constexpr double most_height = 0.5;                                                                // of the width
constexpr double most_of_unit = 0.36;  // of the width: a figure of few units is not blown up
constexpr int rounds_of_fitting = 4;
constexpr double page_width = 420;  // of a figure in a handout

/// The letters of a painter, with ink as a sans serif font has it: a painter reports how wide a text is, not how high.
class PainterMathsFont final : public MathsFont {
 public:
  explicit PainterMathsFont(const Painter& painter) : painter_(painter) {}

  InkBox ink(MathsStyle style, MathsSize size, std::string_view utf8) const override {
    constexpr float capital = 0.73f, small = 0.56f, descender = 0.2f, axis = 0.36f;
    const auto advance = static_cast<float>(painter_.extent(utf8, lettering(style, size)).width);
    const float e = em(size);
    if (utf8 == "′") return {0.3f * em(size), 0, 0.3f * em(size), capital * em(size), 0};  // estimates know no prime
    if (utf8 == "−" || utf8 == "=" || utf8 == "·") return {advance, 0, advance, axis * e, -axis * e};
    const bool low = utf8.find_first_not_of("acegmnopqrsuvwxyz") == std::string_view::npos;
    const bool hangs = utf8.find_first_of("gjpqy") != std::string_view::npos;
    return {advance, 0, advance, (low ? small : capital) * e, hangs ? descender * e : 0};
  }
  float em(MathsSize size) const override {
    return static_cast<float>(painter_.px(em_of(lettering(MathsStyle::upright, size))));
  }
  static Lettering lettering(MathsStyle style, MathsSize size) {
    const bool script = size == MathsSize::script;
    switch (style) {
    case MathsStyle::upright:
      return script ? Lettering::script : Lettering::body;
    case MathsStyle::italic:
      return script ? Lettering::script_italic : Lettering::italic;
    case MathsStyle::bold:
      return script ? Lettering::script_strong : Lettering::strong;
    }
    return Lettering::body;
  }

 private:
  const Painter& painter_;
};

MathsBox set_label(const Painter& painter, const FigureLabel& label) {
  const PainterMathsFont font(painter);
  const Formula formula{{}, FormulaForm::in_text, label.formula};
  return std::move(set_displayed(formula, font, std::numeric_limits<float>::max()).front());
}

/// Where a label lies from its place, in pixels, y down.
PaintArea area_of(const Painter& painter, const FigureLabel& label) {
  double width = 0, above = 0, below = 0;
  if (label.formula.empty()) {
    const TextExtent size = painter.extent(label.words, Lettering::label);
    width = size.width, above = size.above * 0.75, below = size.below * 0.75;
  } else {
    const MathsBox box = set_label(painter, label);
    width = box.width, above = box.above, below = box.below;
  }
  const double gap = painter.px(label_gap), height = above + below;
  const Vec2d middle(label.side.x * (width / 2 + gap), -label.side.y * (height / 2 + gap));
  return {middle - Vec2d(width, height) / 2.0, middle + Vec2d(width, height) / 2.0};
}

struct Bounds {
  Vec2d low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
  void add(const Vec2d& place) {
    low = {std::min(low.x, place.x), std::min(low.y, place.y)};
    high = {std::max(high.x, place.x), std::max(high.y, place.y)};
  }
};

struct AddPlaces {
  Bounds& bounds;
  void operator()(const FigureLine& line) const {
    for (const Vec2d& place : line.places) bounds.add(place);
  }
  void operator()(const FigureArea& area) const {
    for (const Vec2d& corner : area.corners) bounds.add(corner);
  }
  void operator()(const FigureDot& dot) const { bounds.add(dot.at); }
  void operator()(const FigureLabel& label) const { bounds.add(label.at); }
};

/// From the figure's plane to the painter's pixels, from the figure's upper left corner.
struct Fit {
  double scale = 1;
  Vec2d origin{0, 0};  ///< pixels: where (0, 0) of the plane is
  double height = 0;
  Vec2d operator()(const Vec2d& place) const { return {origin.x + scale * place.x, origin.y - scale * place.y}; }
};

/// The largest scale at which all marks fit into the width, with their labels.
Fit fit(const Painter& painter, const Figure& figure, double width) {
  Bounds plane;
  for (const FigureMark& mark : figure.marks) std::visit(AddPlaces{plane}, mark);
  const Vec2d size = plane.high - plane.low;
  const double edge = painter.px(figure_edge + dot_radius);
  Vec2d before(edge, edge), behind(edge, edge);  // left and above, right and below: what labels need
  Fit fitted;
  for (int round = 0; round < rounds_of_fitting; ++round) {
    const double room_x = std::max(width - before.x - behind.x, 1.0),
                 room_y = std::max(most_height * width - before.y - behind.y, 1.0);
    fitted.scale =
        std::min({size.x > 0 ? room_x / size.x : room_x, size.y > 0 ? room_y / size.y : room_x, most_of_unit * width});
    const double free = std::max(width - before.x - behind.x - fitted.scale * size.x, 0.0) / 2;
    fitted.origin = {before.x + free - fitted.scale * plane.low.x, before.y + fitted.scale * plane.high.y};
    fitted.height = before.y + behind.y + fitted.scale * size.y;
    const Vec2d low = fitted({plane.low.x, plane.high.y}), high = fitted({plane.high.x, plane.low.y});
    before = behind = {edge, edge};
    for (const FigureMark& mark : figure.marks)
      if (const auto* label = std::get_if<FigureLabel>(&mark)) {
        const PaintArea area = area_of(painter, *label);
        const Vec2d at = fitted(label->at);
        before = {std::max(before.x, low.x - at.x - area.low.x + edge / 2),
                  std::max(before.y, low.y - at.y - area.low.y + edge / 2)};
        behind = {std::max(behind.x, at.x + area.high.x - high.x + edge / 2),
                  std::max(behind.y, at.y + area.high.y - high.y + edge / 2)};
      }
  }
  return fitted;
}

/// Draws marks at their places.
struct DrawMark {
  Painter& painter;
  const Fit& fitted;
  Vec2d corner;

  Vec2d place(const Vec2d& at) const { return corner + fitted(at); }

  void operator()(const FigureLine& line) const {
    std::vector<Vec2d> places;
    for (const Vec2d& at : line.places) places.push_back(place(at));
    if (line.tip == LineTip::arrow) draw_tip(places, line.stroke);
    painter.polyline(places, line.stroke);
  }

  /// The line ends where its tip begins.
  void draw_tip(std::vector<Vec2d>& places, const Stroke& stroke) const {
    Vec2d& end = places.back();
    const Vec2d way = end - places[places.size() - 2];
    const double length = figure_length(way);
    if (!(length > 0)) return;
    const Vec2d along = way / length, across(-along.y, along.x);
    const double tip = std::min(painter.px(tip_length), length);
    const Vec2d foot = end - tip * along;
    const std::array corners{end, foot + painter.px(tip_width / 2) * across, foot - painter.px(tip_width / 2) * across};
    painter.polygon(corners, {.fill = stroke.tint, .stroke = {}});
    end = foot;
  }

  void operator()(const FigureArea& area) const {
    std::vector<Vec2d> corners;
    for (const Vec2d& at : area.corners) corners.push_back(place(at));
    painter.polygon(corners, {.fill = area.fill, .stroke = {}});
  }

  void operator()(const FigureDot& dot) const {
    painter.circle(place(dot.at), painter.px(dot_radius), {.fill = dot.tint, .stroke = {}});
  }

  void operator()(const FigureLabel& label) const {
    const PaintArea area = area_of(painter, label);
    const Vec2d at = place(label.at), low = at + area.low;
    if (label.formula.empty())
      return painter.text(
          at + (area.low + area.high) / 2.0, label.words,
          {.anchor = TextAnchor::middle, .level = TextLevel::middle, .tint = label.tint, .ground = TextGround::rim});
    const MathsBox box = set_label(painter, label);
    const Vec2d baseline(low.x, low.y + box.above);
    const PainterMathsFont font(painter);
    for (const MathsText& text : box.texts) {  // in the middle of its room: a file's widths are estimates
      const double advance = font.ink(text.style, text.size, text.text).advance;
      painter.text(baseline + Vec2d(text.x + advance / 2, text.y), text.text,
                   {.lettering = PainterMathsFont::lettering(text.style, text.size),
                    .anchor = TextAnchor::middle,
                    .tint = label.tint,
                    .ground = TextGround::rim});
    }
    for (const MathsStroke& stroke : box.strokes) {
      std::vector<Vec2d> points;
      for (const MathsPoint& point : stroke.points) points.push_back(baseline + Vec2d(point.x, point.y));
      painter.polyline(points, {.tint = label.tint, .width = stroke.thickness / painter.px(1)});
    }
    for (const MathsRule& rule : box.rules) {
      const Vec2d from = baseline + Vec2d(rule.x, rule.y);
      painter.rectangle({from, from + Vec2d(rule.width, rule.height)}, {.fill = label.tint, .stroke = {}});
    }
  }
};

std::vector<std::string> note_lines(const Painter& painter, const Figure& figure, double width) {
  if (figure.note.empty()) return {};
  return lines_of(painter, figure.note, Lettering::label, width);
}

double note_line_height(const Painter& painter) {
  const TextExtent size = painter.extent("x", Lettering::label);
  return size.above + size.below;
}

/// Words of a label as a part of its formula.
void add_words(MathsRow& row, std::string_view words) {
  if (!words.empty()) row.push_back({MathsWords{std::string(words)}});
}

}  // namespace

FigureLabel read_label(std::string_view text, const SourcePlace& start) {
  FigureLabel label;
  const std::vector<FormulaMark> formulas = find_formulas(text, start);
  if (formulas.empty()) {
    label.words = text;
    return label;
  }
  std::size_t at = 0;
  for (const FormulaMark& mark : formulas) {
    add_words(label.formula, text.substr(at, mark.begin - at));
    const Formula formula =
        read_formula(mark.notation(text), FormulaForm::in_text, place_in(text, mark.begin + mark.sign_length(), start));
    label.formula.insert(label.formula.end(), formula.row.begin(), formula.row.end());
    at = mark.end;
  }
  add_words(label.formula, text.substr(at));
  return label;
}

double figure_height(const Painter& painter, const Figure& figure, double width) {
  const auto lines = static_cast<double>(note_lines(painter, figure, width).size());
  return std::ceil(fit(painter, figure, width).height + lines * note_line_height(painter));
}

void draw_figure(Painter& painter, const Figure& figure, const Vec2d& corner, double width) {
  const Fit fitted = fit(painter, figure, width);
  const DrawMark draw{painter, fitted, corner};
  for (const FigureMark& mark : figure.marks)  // labels lie over all that is drawn
    if (!std::holds_alternative<FigureLabel>(mark)) std::visit(draw, mark);
  for (const FigureMark& mark : figure.marks)
    if (const auto* label = std::get_if<FigureLabel>(&mark)) draw(*label);
  Vec2d middle = corner + Vec2d(width / 2, fitted.height + note_line_height(painter) / 2);
  for (const std::string& line : note_lines(painter, figure, width)) {
    painter.text(middle, line, {.anchor = TextAnchor::middle, .level = TextLevel::middle, .tint = {Role::quiet}});
    middle.y += note_line_height(painter);
  }
}

std::string figure_svg(const Figure& figure) {
  const SvgPainter measuring(page_width, page_width, "");
  SvgPainter painter(page_width, figure_height(measuring, figure, page_width), figure_words(figure));
  draw_figure(painter, figure, {0, 0}, page_width);
  return painter.finish();
}

}  // namespace ps
