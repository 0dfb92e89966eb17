#include "cli/print_rows.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/check.h"
#include "cli/interrupt.h"
#include "document/document_provenance.h"
#include "inspect/canvas_rows.h"
#include "record/value_text.h"
#include "render/provenance_json.h"

namespace ps::cli {
namespace {

using RowsJson = nlohmann::ordered_json;

RowsJson span_json(const std::optional<ColumnSpan>& span) {
  return span ? RowsJson::array({span->left, span->right}) : RowsJson();
}

/// The colours that are interpolated between the ends of the row, linear; null for a row that has none.
RowsJson colours_json(const CanvasRow& row) {
  if (!row.outlined) return {};
  RowsJson ends = RowsJson::array();
  for (const Vec3d& colour : row.end_colours) ends.push_back({colour.x, colour.y, colour.z});
  return ends;
}

std::string colour_text(const CanvasRow& row, std::size_t end) {
  return row.outlined ? vector_text(row.end_colours[end]) : "none";
}

std::string rows_json(const std::vector<CanvasShapeRows>& shapes, const Provenance& made) {
  RowsJson json{{"triangles", RowsJson::array()}};
  for (const CanvasShapeRows& shape : shapes) {
    RowsJson one{{"item", shape.item}, {"corners", RowsJson::array()}, {"rows", RowsJson::array()}};
    for (const Vec2i& vertex : shape.vertices) one["corners"].push_back({vertex.x, vertex.y});
    for (const CanvasRow& row : shape.rows)
      one["rows"].push_back({{"y", row.y},
                             {"interpolated", span_json(row.outlined)},
                             {"filled", span_json(row.filled)},
                             {"end_colours", colours_json(row)}});
    json["triangles"].push_back(std::move(one));
  }
  json["provenance"] = provenance_json(made);
  return json.dump(2, ' ', false, RowsJson::error_handler_t::replace) + "\n";
}

}  // namespace

std::string rows_text(const Document& document, Vec2i pixel, bool json) {
  const auto shapes =
      canvas_rows(document.scene, view_of(document), document.a.settings, pixel, interruptible_progress());
  if (shapes.empty())
    throw InputError(
        fmt::format("--rows: there is no filled triangle or polygon of the canvas at pixel {},{}", pixel.x, pixel.y));
  if (json) return rows_json(shapes, document_provenance(document, Side::a));
  std::string text;
  for (const CanvasShapeRows& shape : shapes) {
    std::vector<std::string> vertices;
    for (const Vec2i& v : shape.vertices) vertices.push_back(fmt::format("({}, {})", v.x, v.y));
    text += fmt::format("canvas item {}, {}, vertices at pixels {}\n{:>7} {:>14} {:>14}  {:<30} {}\n", shape.item,
                        shape_name(shape), fmt::join(vertices, ", "), "row", "interpolated", "filled",
                        "colour of the left end", "colour of the right end");
    for (const CanvasRow& row : shape.rows)
      text += fmt::format("{:>7} {:>14} {:>14}  {:<30} {}{}\n", row.y, span_text(row.outlined), span_text(row.filled),
                          colour_text(row, 0), colour_text(row, 1), row.y == pixel.y ? "  <- the pixel's row" : "");
    text += "\n";
  }
  return text;
}

}  // namespace ps::cli
