#include <fmt/format.h>

#include "scene/scene_draft.h"

namespace ps {
namespace {

Blend read_blend(const SceneSource& source, const SceneFields& fields) {
  const SceneTerm* term = fields.find("blend");
  if (term == nullptr) return Blend::replace;
  const std::string blend = source.values.name(*term, "replace, additive or subtractive");
  if (blend == "replace") return Blend::replace;
  if (blend == "additive") return Blend::additive;
  if (blend == "subtractive") return Blend::subtractive;
  source.values.fail(*term, "replace, additive or subtractive");
}

}  // namespace

void read_line(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneFields fields(source.values, entry, {"from", "to", "color", "blend"});
  CanvasLine line;
  line.points = {source.values.vec2(fields.require("from")), source.values.vec2(fields.require("to"))};
  if (const auto* term = fields.find("color")) line.colour = source.values.colour(*term);
  line.blend = read_blend(source, fields);
  draft.canvas_items.emplace_back(line);
}

void read_canvas_triangle(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneValues& values = source.values;
  const SceneFields fields(values, entry, {"vertices", "color", "colors", "h", "filled", "outline", "blend"});
  CanvasTriangle triangle;
  const auto& points = source.values.corners(fields.require("vertices"));
  for (std::size_t i = 0; i < 3; ++i) triangle.points[i] = values.vec2(points[i]);
  if (const auto* term = fields.find("color")) {
    fields.forbid({"colors"}, "only one of 'color' and 'colors'");
    triangle.colours.fill(values.colour(*term));
  } else if (const auto* each = fields.find("colors")) {
    const auto& terms = source.values.corners(*each);
    for (std::size_t i = 0; i < 3; ++i) triangle.colours[i] = values.colour(terms[i]);
  }
  if (const auto* term = fields.find("h")) {
    const auto& terms = source.values.corners(*term);
    for (std::size_t i = 0; i < 3; ++i) triangle.h[i] = values.number(terms[i]);
  }
  if (const auto* term = fields.find("filled")) triangle.filled = values.on_off(*term);
  if (const auto* term = fields.find("outline")) triangle.outline = values.colour(*term);
  triangle.blend = read_blend(source, fields);
  draft.canvas_items.emplace_back(triangle);
}

}  // namespace ps
