#include "gui/panels/pictures/canvas_rows_view.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "gui/base/values.h"
#include "gui/theme/theme.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

/// The rows for scripts to read.
void publish_rows(const std::vector<CanvasTriangleRows>& triangles, const std::string& name) {
  for (std::size_t i = 0; values().find(fmt::format("{}/rows/{}", name, i)); ++i)
    values().withdraw(fmt::format("{}/rows/{}", name, i));
  std::size_t count = 0;
  for (const CanvasTriangleRows& triangle : triangles)
    for (const CanvasRow& row : triangle.rows)
      values().publish(fmt::format("{}/rows/{}", name, count++),
                       fmt::format("{}: {} {}", row.y, span_text(row.outlined), span_text(row.filled)));
  values().publish(name + "/rows", static_cast<double>(count));
}

void update_rows(const Session& session, Side side, CanvasRowsState& state, const std::string& name) {
  const auto story = session.story(side);
  if (story == state.shown || !story) return;
  state.shown = story;
  Progress progress;
  state.triangles = canvas_rows(session.scene(), session.view(), session.settings(side), story->pixel, progress);
  publish_rows(state.triangles, name);
}

void rows_table(const CanvasTriangleRows& triangle, int pixel_row) {
  if (!ImGui::BeginTable("rows", 3, ImGuiTableFlags_SizingStretchSame)) return;
  for (const char* heading : {"row", "interpolated", "filled"}) ImGui::TableSetupColumn(heading);
  ImGui::TableHeadersRow();
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(triangle.rows.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const CanvasRow& row = triangle.rows[static_cast<std::size_t>(i)];
      const std::string marked = fmt::format("{}{}", row.y, row.y == pixel_row ? "  the pixel" : "");
      for (const std::string& text : {marked, span_text(row.outlined), span_text(row.filled)}) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(text.c_str());
      }
    }
  ImGui::EndTable();
}

}  // namespace

bool has_canvas_rows(const Session& session) {
  const auto& items = *session.scene().canvas_items;
  return std::any_of(items.begin(), items.end(), [](const CanvasItem& item) {
    const auto* triangle = std::get_if<CanvasTriangle>(&item);
    return triangle != nullptr && triangle->filled;
  });
}

void canvas_rows_view(const Session& session, Side side, CanvasRowsState& state, const std::string& name) {
  update_rows(session, side, state, name);
  for (const CanvasTriangleRows& triangle : state.triangles) {
    const FontScope font(Face::mono);
    ImGui::PushID(triangle.item);
    ImGui::Text("canvas item %d", triangle.item);
    rows_table(triangle, state.shown->pixel.y);
    ImGui::PopID();
  }
  if (state.triangles.empty()) ImGui::TextUnformatted("No triangle of the canvas is at this pixel.");
}

}  // namespace ps::gui
