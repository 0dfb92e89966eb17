#pragma once
#include <memory>
#include <optional>

#include "gui/session/session.h"
#include "inspect/vertex_chain.h"

namespace ps::gui {

/// What the panel of the vertex remembers of itself.
struct VertexPanelState {
  std::optional<VertexId> vertex;
  bool keep = false;  ///< stays with the vertex when another pixel is picked
  VertexEdits edits;
  std::optional<VertexChain> chain;          ///< with the edits; empty while the tab is not shown
  std::optional<VertexChain> plain;          ///< without them
  std::shared_ptr<const PixelStory> picked;  ///< the story that the vertex was picked from
  Vec2i pixel{-1, -1};
  std::uint64_t revision = 0;  ///< of the geometry
  std::string error;
};

/// Picks the vertex for the picked pixel and follows it. Without effect on a state that is not shown.
void update_vertex(Session& session, VertexPanelState& state, bool shown);

/// The way of the vertex from its model to the canvas, step by step, with matrices and numbers. `filled`: it has the
/// whole window; answers whether that shall change.
bool vertex_panel(Session& session, VertexPanelState& state, bool filled);

}  // namespace ps::gui
