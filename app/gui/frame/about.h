#pragma once

namespace ps::gui {

/// What this program is and what it runs on: the things that a report of a fault needs.
struct About {
  bool open = false;
  void draw();
};

}  // namespace ps::gui
