#pragma once
#include <string>
#include <vector>

#include "gui/frame/panel_table.h"

namespace ps::gui {

/// The regions of the window with the panels in them: lesson and options on the left, the pixel's story on the right,
/// the pictures between them, and below these one of the others. The document's layout says how the window is divided.
class Regions {
 public:
  /// All must outlive it.
  Regions(Session& session, PanelStates& states, const std::vector<Panel>& panels)
      : session_(session), my_(states), panels_(panels) {}

  /// Draws all of it. `offers_first_look`: the offer to lead a newcomer round stands above the options.
  void draw(const Area& area, bool offers_first_look);
  /// How the offer was answered in this frame.
  bool first_look_answered() const { return answered_; }

 private:
  void divided(const Area& area);
  void left(const Area& area);
  void right(const Area& area);
  void below(const Area& area);
  Area first_look(const Area& area);
  /// A region with its heading, and the panel in it. `region` is its name in the document's layout; "" has no heading.
  void panel_in(const Panel& panel, const std::string& region, const Area& area);
  const Panel& panel(std::string_view name) const { return find_panel(panels_, name); }

  Session& session_;
  PanelStates& my_;
  const std::vector<Panel>& panels_;
  bool offers_first_look_ = false, answered_ = false;
  float lesson_share_ = 0.6f;  ///< of the left region's height, while a lesson is open
};

}  // namespace ps::gui
