#pragma once

namespace ps::gui {

/// The program's version and the system that it runs on: the facts that a report of a fault needs.
struct About {
  bool open = false;
  void draw();
};

}  // namespace ps::gui
