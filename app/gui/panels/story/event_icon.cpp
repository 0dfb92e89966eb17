#include "gui/panels/story/event_icon.h"

#include <cmath>
#include <numbers>

#include "gui/theme/theme.h"

namespace ps::gui {
namespace {

enum class Fill { hollow, filled };

struct IconPen {
  ImDrawList& list;
  ImVec2 middle;
  float radius;

  float stroke() const { return px(1.5); }
  ImVec2 at(float x, float y) const { return {middle.x + x * radius, middle.y + y * radius}; }

  void circle(ImVec4 colour, Fill fill) const {
    if (fill == Fill::filled)
      list.AddCircleFilled(middle, radius, colour_u32(colour));
    else
      list.AddCircle(middle, radius, colour_u32(colour), 0, stroke());
  }
  void triangle(ImVec4 colour, Fill fill) const {
    const ImVec2 a = at(0, -1), b = at(0.95f, 0.8f), c = at(-0.95f, 0.8f);
    if (fill == Fill::filled)
      list.AddTriangleFilled(a, b, c, colour_u32(colour));
    else
      list.AddTriangle(a, b, c, colour_u32(colour), stroke());
  }
  void square(ImVec4 colour, Fill fill) const {
    if (fill == Fill::filled)
      list.AddRectFilled(at(-0.85f, -0.85f), at(0.85f, 0.85f), colour_u32(colour));
    else
      list.AddRect(at(-0.85f, -0.85f), at(0.85f, 0.85f), colour_u32(colour), 0, 0, stroke());
  }
  void diamond(ImVec4 colour) const {
    list.AddQuadFilled(at(0, -1), at(1, 0), at(0, 1), at(-1, 0), colour_u32(colour));
  }
  void arrow(ImVec4 colour) const {
    list.AddLine(at(-1, 0), at(0.9f, 0), colour_u32(colour), stroke());
    list.AddLine(at(0.2f, -0.7f), at(0.9f, 0), colour_u32(colour), stroke());
    list.AddLine(at(0.2f, 0.7f), at(0.9f, 0), colour_u32(colour), stroke());
  }
  void cross(ImVec4 colour) const {
    list.AddLine(at(-0.8f, -0.8f), at(0.8f, 0.8f), colour_u32(colour), stroke());
    list.AddLine(at(-0.8f, 0.8f), at(0.8f, -0.8f), colour_u32(colour), stroke());
  }
  void sun(ImVec4 colour) const {
    list.AddCircleFilled(middle, radius * 0.45f, colour_u32(colour));
    for (int i = 0; i < 8; ++i) {
      const float angle = static_cast<float>(i) * std::numbers::pi_v<float> / 4;
      const float c = std::cos(angle), s = std::sin(angle);
      list.AddLine(at(c * 0.65f, s * 0.65f), at(c, s), colour_u32(colour), stroke());
    }
  }
  void line(ImVec4 colour) const { list.AddLine(at(-0.9f, 0.6f), at(0.9f, -0.6f), colour_u32(colour), px(2)); }
};

ImVec4 colour_of(const Vec3d& c) {
  const auto level = [](double v) { return static_cast<float>(v < 0 ? 0 : v > 1 ? 1 : v); };
  return {level(c.x), level(c.y), level(c.z), 1};
}

struct Drawer {
  const IconPen& pen;
  const Palette& p;

  void operator()(const RayEvent&) const { pen.arrow(p.text); }
  void operator()(const NodeEvent& e) const { pen.square(e.entered ? p.right_mark : p.text_quiet, Fill::hollow); }
  void operator()(const SphereTestEvent& e) const { test(e.outcome, &IconPen::circle); }
  void operator()(const TriangleTestEvent& e) const { test(e.outcome, &IconPen::triangle); }
  void operator()(const SolidTestEvent& e) const { test(e.outcome, &IconPen::square); }
  void operator()(const HitEvent&) const { pen.diamond(p.right_mark); }
  void operator()(const MissEvent&) const { pen.cross(p.text_quiet); }
  void operator()(const TextureEvent&) const {
    pen.square(p.text_quiet, Fill::hollow);
    pen.list.AddRectFilled(pen.at(-0.85f, -0.85f), pen.middle, colour_u32(p.text_quiet));
    pen.list.AddRectFilled(pen.middle, pen.at(0.85f, 0.85f), colour_u32(p.text_quiet));
  }
  void operator()(const LightEvent& e) const {
    if (e.blocker || e.visible <= 0)
      pen.cross(p.wrong_mark);
    else
      pen.sun(e.below_horizon ? p.text_quiet : p.right_mark);
  }
  void operator()(const VertexLightEvent& e) const { swatch(e.light + e.extra); }
  void operator()(const ShadeEvent& e) const { swatch(e.local); }
  void operator()(const ReflectionEvent& e) const { swatch(e.result); }
  void operator()(const RefractionEvent& e) const { swatch(e.result); }
  void operator()(const CutoffEvent&) const { pen.cross(p.text_quiet); }
  void operator()(const SampleEvent& e) const { swatch(e.colour); }
  void operator()(const CompareEvent& e) const {
    pen.square(e.subdivides ? p.right_mark : p.text_quiet, e.subdivides ? Fill::filled : Fill::hollow);
  }
  void operator()(const ReuseEvent& e) const { e.met ? pen.diamond(p.right_mark) : pen.cross(p.text_quiet); }
  void operator()(const NormalMapEvent&) const { pen.arrow(p.right_mark); }
  void operator()(const ParallaxEvent&) const { pen.arrow(p.right_mark); }
  void operator()(const ShadowMapEvent& e) const {
    pen.square(e.visible > 0 ? p.right_mark : p.wrong_mark,
               e.visible > 0 && e.visible < 1 ? Fill::hollow : Fill::filled);
  }
  void operator()(const StencilEvent& e) const {
    pen.circle(e.stored == 0 ? p.right_mark : p.wrong_mark, Fill::hollow);
  }
  void operator()(const EnvironmentEvent& e) const { swatch(e.result); }
  void operator()(const RejectEvent&) const { pen.triangle(p.wrong_mark, Fill::hollow); }
  void operator()(const FragmentEvent& e) const {
    pen.triangle(e.depth == FragmentEvent::Depth::failed ? p.wrong_mark : p.right_mark, Fill::filled);
  }
  void operator()(const PolygonEvent& e) const { pen.diamond(e.row ? colour_of(e.row->colour) : p.right_mark); }
  void operator()(const CoverageEvent& e) const { pen.square(e.covered ? p.right_mark : p.wrong_mark, Fill::hollow); }
  void operator()(const WriteEvent& e) const { swatch(e.after); }
  void operator()(const LineEvent&) const { pen.line(p.right_mark); }
  void operator()(const PixelEvent& e) const {
    swatch({e.display[0] / 255.0, e.display[1] / 255.0, e.display[2] / 255.0});
  }

 private:
  void test(TestOutcome outcome, void (IconPen::*shape)(ImVec4, Fill) const) const {
    switch (outcome) {
    case TestOutcome::accepted:
      (pen.*shape)(p.right_mark, Fill::filled);
      return;
    case TestOutcome::farther:
    case TestOutcome::tie_lost:
      (pen.*shape)(p.text_quiet, Fill::filled);
      return;
    case TestOutcome::missed:
    case TestOutcome::before_range:
    case TestOutcome::beyond_range:
    case TestOutcome::back_side:
    case TestOutcome::parallel:
    case TestOutcome::degenerate:
    case TestOutcome::excluded:
      (pen.*shape)(p.wrong_mark, Fill::hollow);
      return;
    }
  }
  void swatch(const Vec3d& colour) const {
    pen.square(colour_of(colour), Fill::filled);
    pen.square(p.line_strong, Fill::hollow);
  }
};

}  // namespace

void draw_event_icon(ImDrawList& list, const Event& event, ImVec2 middle, float size) {
  const IconPen pen{list, middle, size / 2};
  std::visit(Drawer{pen, palette()}, event.data);
}

}  // namespace ps::gui
