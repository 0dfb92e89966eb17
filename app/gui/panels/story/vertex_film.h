#pragma once
#include <optional>

#include "gui/session/session.h"
#include "inspect/chain_stages.h"

namespace ps::gui {

/// The animation of a vertex and its model from model space to the canvas.
struct VertexFilm {
  bool playing = false;
  double time = 0;                    ///< 0 = in the model, 4 = on the canvas
  double last = 0;                    ///< when it was moved on, seconds on the window's clock
  std::optional<ChainStages> stages;  ///< of what `made_for` says
  struct Subject {
    SceneRevision scene;
    View view;
    Settings settings;
    VertexId vertex;
    VertexEdits edits;
    bool operator==(const Subject&) const = default;
  };
  std::optional<Subject> made_for;
};

/// Begins to play, from the model if it is at its end.
void play_film(VertexFilm& film);

/// The model as it moves from space to space, with the vertex marked; a button that plays it, and its time to be set.
/// As wide as `width`.
void vertex_film(Session& session, VertexFilm& film, const VertexId& vertex, float width);

}  // namespace ps::gui
