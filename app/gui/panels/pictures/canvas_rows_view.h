#pragma once
#include <memory>
#include <string>
#include <vector>

#include "gui/session/session.h"
#include "inspect/canvas_rows.h"

namespace ps::gui {

/// The rows on show, and the story that they belong to.
struct CanvasRowsState {
  std::shared_ptr<const PixelStory> shown;
  std::vector<CanvasShapeRows> shapes;
};

/// Whether the scene has filled triangles or polygons on the canvas.
bool has_canvas_rows(const Session& session);

/// A table of the rows of the shapes on the canvas at the picked pixel: between the pixels of their interpolated edges,
/// with the colours at both ends, and as the fill rule fills them. Published below `name`: "a/rows" (how many),
/// "a/rows/0", "a/row-ends/0" and so on.
void canvas_rows_view(const Session& session, Side side, CanvasRowsState& state, const std::string& name);

}  // namespace ps::gui
