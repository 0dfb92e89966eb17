#pragma once
#include <memory>
#include <optional>

#include "gui/panels/story/vertex_film.h"
#include "gui/session/session.h"
#include "inspect/vertex_chain.h"

namespace ps::gui {

/// State of the panel of the vertex.
struct VertexPanelState {
  std::optional<VertexId> nearest;          ///< the one next to the picked pixel
  std::shared_ptr<const PixelStory> story;  ///< that `nearest` was found from
  std::optional<std::uint64_t> geometry;    ///< its revision then
  std::optional<VertexChain> chain;         ///< of the vertex that is followed, with the document's edits
  std::optional<VertexChain> plain;         ///< without them
  std::string error;
  VertexFilm film;
};

/// The vertex that is followed: the one that the document keeps, else the one next to the picked pixel.
std::optional<VertexId> followed_vertex(Session& session, VertexPanelState& state);
/// Its way from the model to the canvas, with what is tried out; nullptr where there is none.
const VertexChain* followed_chain(Session& session, VertexPanelState& state);

/// The way of the vertex from its model to the canvas, step by step, with matrices and numbers. `filled`: it has the
/// whole window; answers whether that shall change.
bool vertex_panel(Session& session, VertexPanelState& state, bool filled);

}  // namespace ps::gui
