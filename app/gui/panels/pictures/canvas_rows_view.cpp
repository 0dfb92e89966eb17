#include "gui/panels/pictures/canvas_rows_view.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "gui/base/values.h"
#include "gui/theme/theme.h"
#include "gui/widgets/widgets.h"
#include "record/value_text.h"

namespace ps::gui {
namespace {

/// The values interpolated along the edges, at both ends of the row.
std::string ends_text(const CanvasRow& row) {
  if (!row.outlined) return "none";
  return vector_text(row.end_colours[0]) + " to " + vector_text(row.end_colours[1]);
}

/// The rows for scripts to read.
void publish_rows(const std::vector<CanvasShapeRows>& shapes, const std::string& name) {
  for (std::size_t i = 0; values().find(fmt::format("{}/rows/{}", name, i)); ++i) {
    values().withdraw(fmt::format("{}/rows/{}", name, i));
    values().withdraw(fmt::format("{}/row-ends/{}", name, i));
  }
  std::size_t count = 0;
  for (const CanvasShapeRows& shape : shapes)
    for (const CanvasRow& row : shape.rows) {
      values().publish(fmt::format("{}/rows/{}", name, count),
                       fmt::format("{}: {} {}", row.y, span_text(row.outlined), span_text(row.filled)));
      values().publish(fmt::format("{}/row-ends/{}", name, count++), ends_text(row));
    }
  values().publish(name + "/rows", static_cast<double>(count));
}

void update_rows(const Session& session, Side side, CanvasRowsState& state, const std::string& name) {
  const auto story = session.story(side);
  if (story == state.shown || !story) return;
  state.shown = story;
  Progress progress;
  state.shapes = canvas_rows(session.scene(), session.view(), session.settings(side), story->pixel, progress);
  publish_rows(state.shapes, name);
}

void rows_table(const CanvasShapeRows& shape, int pixel_row) {
  if (!ImGui::BeginTable("rows", 4, ImGuiTableFlags_SizingStretchSame)) return;
  for (const char* heading : {"row", "interpolated", "filled", "colours of the ends"}) ImGui::TableSetupColumn(heading);
  ImGui::TableHeadersRow();
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(shape.rows.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const CanvasRow& row = shape.rows[static_cast<std::size_t>(i)];
      const std::string marked = fmt::format("{}{}", row.y, row.y == pixel_row ? "  the pixel" : "");
      for (const std::string& text : {marked, span_text(row.outlined), span_text(row.filled), ends_text(row)}) {
        ImGui::TableNextColumn();
        show_text(text);
      }
    }
  ImGui::EndTable();
}

}  // namespace

bool has_canvas_rows(const Session& session) {
  const auto& items = *session.scene().canvas_items;
  return std::any_of(items.begin(), items.end(), [](const CanvasItem& item) {
    const auto* triangle = std::get_if<CanvasTriangle>(&item);
    const auto* polygon = std::get_if<CanvasPolygon>(&item);
    return (triangle && triangle->filled) || (polygon && polygon->filled);
  });
}

void canvas_rows_view(const Session& session, Side side, CanvasRowsState& state, const std::string& name) {
  update_rows(session, side, state, name);
  for (const CanvasShapeRows& shape : state.shapes) {
    const FontScope font(Face::mono);
    ImGui::PushID(shape.item);
    ImGui::Text("canvas item %d, %s", shape.item, shape_name(shape).c_str());
    rows_table(shape, state.shown->pixel.y);
    ImGui::PopID();
  }
  if (state.shapes.empty()) show_text("No triangle or polygon of the canvas is at this pixel.");
}

}  // namespace ps::gui
