#pragma once
#include "gui/panels/sheet.h"

namespace ps::gui {

/// The program's version and the system that it runs on: the facts that a report of a fault needs.
class About final : public Sheet {
 public:
  explicit About(const PanelHost& host) : Sheet(host, "about", {"Pixelscope", {560, 0}}) {}
  void show() { open(); }

 protected:
  void draw_sheet() override;
};

}  // namespace ps::gui
