#include "cli/print_rows.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/check.h"
#include "cli/interrupt.h"
#include "document/document_provenance.h"
#include "inspect/canvas_rows.h"
#include "render/provenance_json.h"

namespace ps::cli {
namespace {

using RowsJson = nlohmann::ordered_json;

RowsJson span_json(const std::optional<ColumnSpan>& span) {
  return span ? RowsJson::array({span->left, span->right}) : RowsJson();
}

std::string rows_json(const std::vector<CanvasTriangleRows>& triangles, const Provenance& made) {
  RowsJson json{{"triangles", RowsJson::array()}};
  for (const CanvasTriangleRows& triangle : triangles) {
    RowsJson one{{"item", triangle.item}, {"corners", RowsJson::array()}, {"rows", RowsJson::array()}};
    for (const Vec2i& corner : triangle.corners) one["corners"].push_back({corner.x, corner.y});
    for (const CanvasRow& row : triangle.rows)
      one["rows"].push_back(
          {{"y", row.y}, {"interpolated", span_json(row.outlined)}, {"filled", span_json(row.filled)}});
    json["triangles"].push_back(std::move(one));
  }
  json["provenance"] = provenance_json(made);
  return json.dump(2, ' ', false, RowsJson::error_handler_t::replace) + "\n";
}

}  // namespace

std::string rows_text(const Document& document, Vec2i pixel, bool json) {
  const auto triangles =
      canvas_rows(document.scene, view_of(document), document.a.settings, pixel, interruptible_progress());
  if (triangles.empty())
    throw InputError(fmt::format("--rows: there is no filled triangle of the canvas at pixel {},{}", pixel.x, pixel.y));
  if (json) return rows_json(triangles, document_provenance(document, Side::a));
  std::string text;
  for (const CanvasTriangleRows& triangle : triangles) {
    const auto& c = triangle.corners;
    text += fmt::format("canvas item {}, vertices at pixels ({}, {}), ({}, {}), ({}, {})\n{:>7} {:>14} {:>14}\n",
                        triangle.item, c[0].x, c[0].y, c[1].x, c[1].y, c[2].x, c[2].y, "row", "interpolated", "filled");
    for (const CanvasRow& row : triangle.rows)
      text += fmt::format("{:>7} {:>14} {:>14}{}\n", row.y, span_text(row.outlined), span_text(row.filled),
                          row.y == pixel.y ? "  <- the pixel's row" : "");
    text += "\n";
  }
  return text;
}

}  // namespace ps::cli
