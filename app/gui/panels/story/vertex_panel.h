#pragma once
#include <memory>
#include <optional>

#include "gui/panels/panel.h"
#include "gui/panels/story/vertex_film.h"
#include "inspect/vertex_uses.h"

namespace ps::gui {

/// The way of a vertex from its model to the canvas, step by step, with matrices and numbers.
class VertexPanel final : public Panel {
 public:
  explicit VertexPanel(const PanelHost& host);
  bool draw(const Context& context) override;
  void add_actions(Actions& actions) override;
  void offer(Values& out) override;

  /// The way of the vertex that is followed, with what is tried out; nullptr where there is none.
  const VertexChain* followed_chain();

 private:
  /// The triangles at the vertex, looked for once.
  const VertexUses& uses_of(const VertexId& vertex);
  /// The vertex that is followed: the one that the document keeps, else the one next to the picked pixel.
  std::optional<VertexId> followed_vertex();

  std::optional<VertexId> nearest_;          ///< the one next to the picked pixel
  std::shared_ptr<const PixelStory> story_;  ///< that `nearest_` was found from
  std::optional<std::uint64_t> geometry_;    ///< its revision then
  std::optional<VertexChain> chain_;         ///< of the vertex that is followed, with the document's edits
  std::optional<VertexChain> plain_;         ///< without them
  std::string error_;
  std::optional<VertexId> used_vertex_;  ///< that `uses_` belong to, in that geometry
  std::uint64_t used_geometry_ = 0;
  VertexUses uses_;
  VertexFilm film_;
};

}  // namespace ps::gui
