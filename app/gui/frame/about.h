#pragma once
#include "gui/panels/sheet.h"

namespace ps::gui {

/// The program's version and the system that it runs on: the facts that a report of a fault needs.
class About final : public Sheet {
 public:
  explicit About(const PanelHost& host) : Sheet(host, "about") {}
  bool draw(const Context& context) override;
  void show() { open_ = just_opened_ = true; }
};

}  // namespace ps::gui
