#pragma once
#include <array>
#include <functional>
#include <optional>

#include "gui/platform/texture.h"
#include "gui/session/session.h"
#include "gui/work/latest_result.h"
#include "inspect/microscope/drawing.h"

namespace ps::gui {

/// A pixel and a sample point in it.
struct MicroRequest {
  Scene scene;
  View view;
  Settings settings;
  Vec2i pixel{0, 0};
  Vec2d point{0.5, 0.5};
  MicroDetail detail = MicroDetail::first;
};

/// The pixel under the microscope with one reading. Shared, never changed.
struct MicroResult {
  MicroRequest request;
  std::shared_ptr<const Microscope> microscope;
  MicroReading reading;
};

/// State of the microscope's panel.
struct MicroscopePanelState {
  explicit MicroscopePanelState(std::function<void()> wake);

  int chosen = -1;  ///< triangle whose numbers are shown; -1 = the one in front
  LatestResult<MicroRequest, MicroResult> worker;

  std::shared_ptr<const MicroResult> shown;  ///< that the drawings were made from
  int shown_chosen = -1;
  MicroDrawing drawing;
  std::vector<MicroDrawing> texels;
  Texture backdrop;
  std::array<Texture, 2> texel_backdrops;
  std::function<void()> save;  ///< asks where to write the view; empty = it cannot be written
};

/// The panel's drawing as an SVG file; empty before the first pixel.
std::string microscope_drawing(const MicroscopePanelState& state);

/// The picked pixel at panel size. A triangle that is clicked is selected in the story, and the other way round.
/// `filled`: it has the whole window; answers whether that shall change.
bool microscope_panel(Session& session, MicroscopePanelState& state, bool filled);

}  // namespace ps::gui
