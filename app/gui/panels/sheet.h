#pragma once
#include <utility>

#include "gui/panels/panel.h"

namespace ps::gui {

/// A panel over the whole window, which draws itself while it is open (widgets/overlay.h).
class Sheet : public Panel {
 public:
  bool close() override { return std::exchange(open_, false); }

 protected:
  Sheet(const PanelHost& host, std::string_view name) : Panel(host, {.name = name, .place = PanelPlace::over}) {}

  bool open_ = false;
  bool just_opened_ = false;  ///< for Overlay
};

}  // namespace ps::gui
