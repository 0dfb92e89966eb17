#pragma once
#include <array>
#include <functional>
#include <optional>

#include "gui/panels/panel.h"
#include "gui/platform/texture.h"
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
};

/// The picked pixel at panel size. A triangle that is clicked is selected in the story, and the other way round.
class MicroscopePanel final : public Panel {
 public:
  explicit MicroscopePanel(const PanelHost& host);
  bool draw(const Context& context) override;
  void update() override { wait_unless_drawn(state_.worker); }
  bool busy() const override { return works(state_.worker); }

 private:
  MicroscopePanelState state_;
};

}  // namespace ps::gui
