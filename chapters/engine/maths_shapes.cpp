#include "engine/maths_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ps {
namespace {

constexpr float line_of_em = 0.075f;  // as thick as the strokes of the body font
constexpr float accent_line_of_em = 0.06f;
constexpr int curve_points = 12;

float line_width(float em) { return std::max(1.0f, em * line_of_em); }

MathsStroke stroke(float em, std::vector<MathsPoint> points) { return {std::move(points), line_width(em)}; }

/// A cubic Bézier curve as a line of points.
void add_curve(std::vector<MathsPoint>& points, MathsPoint a, MathsPoint b, MathsPoint c, MathsPoint d) {
  for (int i = points.empty() ? 0 : 1; i <= curve_points; ++i) {
    const float t = static_cast<float>(i) / curve_points, s = 1 - t;
    const float wa = s * s * s, wb = 3 * s * s * t, wc = 3 * s * t * t, wd = t * t * t;
    points.push_back({wa * a.x + wb * b.x + wc * c.x + wd * d.x, wa * a.y + wb * b.y + wc * c.y + wd * d.y});
  }
}

struct Shape {
  float width = 0;
  std::vector<std::vector<MathsPoint>> lines;  ///< as opening delimiter
};

Shape parenthesis(float em, float top, float bottom) {
  const float width = 0.34f * em, x0 = 0.09f * em, x1 = 0.29f * em, middle = (top + bottom) / 2;
  Shape shape{width, {{}}};
  add_curve(shape.lines[0], {x1, top}, {x0, top + 0.25f * (middle - top)}, {x0, middle - 0.45f * (middle - top)},
            {x0, middle});
  add_curve(shape.lines[0], {x0, middle}, {x0, middle + 0.45f * (bottom - middle)},
            {x0, bottom - 0.25f * (bottom - middle)}, {x1, bottom});
  return shape;
}

Shape brace(float em, float top, float bottom) {
  const float width = 0.46f * em, x0 = 0.08f * em, x1 = 0.22f * em, x2 = 0.38f * em, middle = (top + bottom) / 2,
              bend = std::min(0.3f * em, (bottom - top) / 4);
  // Two lines, since one that turns back at the middle would have a spike there.
  Shape shape{width, {{}, {}}};
  auto &upper = shape.lines[0], &lower = shape.lines[1];
  add_curve(upper, {x2, top}, {x1, top}, {x1, top + bend * 0.4f}, {x1, top + bend});
  upper.push_back({x1, middle - bend});
  add_curve(upper, {x1, middle - bend}, {x1, middle - bend * 0.3f}, {x1, middle}, {x0, middle});
  add_curve(lower, {x0, middle}, {x1, middle}, {x1, middle + bend * 0.3f}, {x1, middle + bend});
  lower.push_back({x1, bottom - bend});
  add_curve(lower, {x1, bottom - bend}, {x1, bottom - bend * 0.4f}, {x1, bottom}, {x2, bottom});
  return shape;
}

Shape shape_of(std::string_view delimiter, float em, float top, float bottom) {
  const float x0 = std::round(0.12f * em) + 0.5f, foot = x0 + 0.2f * em, middle = (top + bottom) / 2;
  const float bracket = 0.38f * em;
  if (delimiter == "(" || delimiter == ")") return parenthesis(em, top, bottom);
  if (delimiter == "{" || delimiter == "}") return brace(em, top, bottom);
  if (delimiter == "[" || delimiter == "]") return {bracket, {{{foot, top}, {x0, top}, {x0, bottom}, {foot, bottom}}}};
  if (delimiter == "⌊" || delimiter == "⌋") return {bracket, {{{x0, top}, {x0, bottom}, {foot, bottom}}}};
  if (delimiter == "⌈" || delimiter == "⌉") return {bracket, {{{foot, top}, {x0, top}, {x0, bottom}}}};
  if (delimiter == "⟨" || delimiter == "⟩") return {bracket, {{{foot, top}, {0.1f * em, middle}, {foot, bottom}}}};
  if (delimiter == "|") return {2 * x0, {{{x0, top}, {x0, bottom}}}};
  if (delimiter == "‖") {
    const float second = x0 + std::max(3.0f, std::round(0.2f * em));
    return {x0 + second, {{{x0, top}, {x0, bottom}}, {{second, top}, {second, bottom}}}};
  }
  return {};
}

}  // namespace

MathsBox drawn_delimiter(std::string_view delimiter, DelimiterEnd end, float em, float above, float below) {
  Shape shape = shape_of(delimiter, em, -above, below);
  if (end == DelimiterEnd::closing)
    for (auto& line : shape.lines)
      for (MathsPoint& point : line) point.x = shape.width - point.x;
  MathsBox box{shape.width, above, below, {}, {}, {}};
  for (auto& line : shape.lines) box.strokes.push_back(stroke(em, std::move(line)));
  return box;
}

bool always_drawn(std::string_view delimiter) {
  constexpr std::array<std::string_view, 7> drawn{"‖", "⌊", "⌋", "⌈", "⌉", "⟨", "⟩"};
  return std::find(drawn.begin(), drawn.end(), delimiter) != drawn.end();
}

MathsBox drawn_operator(std::string_view sign, float em, float axis) {
  const bool integral = sign == "∫";
  const float half = std::round((integral ? 0.95f : 0.68f) * em);
  const float top = -axis - half, bottom = -axis + half;
  MathsBox box{0, -top, bottom, {}, {}, {}};
  if (sign == "∑") {
    const float width = 1.05f * em, left = 0.08f * em, right = width - 0.08f * em;
    box.width = width;
    box.strokes.push_back(stroke(em, {{right, top + 0.16f * em},
                                      {right, top},
                                      {left, top},
                                      {left + 0.5f * em, -axis},
                                      {left, bottom},
                                      {right, bottom},
                                      {right, bottom - 0.16f * em}}));
  } else if (sign == "∏") {
    const float width = 1.1f * em, left = 0.24f * em, right = width - 0.24f * em, edge = 0.08f * em;
    box.width = width;
    box.strokes = {stroke(em, {{edge, top}, {width - edge, top}}), stroke(em, {{left, top}, {left, bottom}}),
                   stroke(em, {{right, top}, {right, bottom}})};
  } else if (integral) {
    const float width = 0.62f * em, x = width / 2, reach = 0.27f * em, slope = 0.04f * em;
    box.width = width;
    std::vector<MathsPoint> points;
    add_curve(points, {x + reach, top + 0.12f * em}, {x + 0.8f * reach, top - 0.03f * em}, {x + slope, top - 0.1f * em},
              {x + slope, top + 0.45f * em});
    points.push_back({x - slope, bottom - 0.45f * em});
    add_curve(points, {x - slope, bottom - 0.45f * em}, {x - slope, bottom + 0.1f * em},
              {x - 0.8f * reach, bottom + 0.03f * em}, {x - reach, bottom - 0.12f * em});
    box.strokes.push_back(stroke(em, std::move(points)));
  } else {
    return {};
  }
  return box;
}

MathsBox drawn_radical(float em, float above, float below) {
  const float height = above + below, width = std::min(0.62f, 0.52f + 0.04f * height / em) * em;
  const float hook = std::min(height * 0.5f, 0.5f * em);
  MathsBox box{width, above, below, {}, {}, {}};
  box.strokes.push_back(stroke(em, {{0.05f * em, below - hook + 0.06f * em},
                                    {0.17f * em, below - hook},
                                    {0.32f * em, below},
                                    {width, -above + line_width(em) / 2}}));
  return box;
}

MathsBox drawn_accent(MathsAccent accent, float em, float width, float rule) {
  MathsBox box{width, 0, 0, {}, {}, {}};
  switch (accent) {
  case MathsAccent::vector: {
    const float head = 0.12f * em, y = -head;
    box.above = 2 * head;
    box.strokes = {stroke(em, {{0, y}, {width, y}}),
                   stroke(em, {{width - head, y - head}, {width, y}, {width - head, y + head}})};
    break;
  }
  case MathsAccent::hat: {
    const float reach = std::min(width / 2, 0.22f * em), middle = width / 2;
    box.above = 0.2f * em;
    box.strokes = {stroke(em, {{middle - reach, 0}, {middle, -box.above}, {middle + reach, 0}})};
    break;
  }
  case MathsAccent::bar:
    box.above = rule;
    box.rules = {{0, -rule, width, rule}};
    break;
  }
  for (MathsStroke& line : box.strokes) line.thickness = std::max(1.0f, accent_line_of_em * em);
  return box;
}

}  // namespace ps
