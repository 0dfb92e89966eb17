#include "gui/session/session.h"

namespace ps::gui {

void Session::draw_again() {
  prepared_->clear();
  for (const Side side : both_sides) {
    renderers_[index_of(side)] = std::make_unique<RenderWorker>(prepared_, host_.wake);
    inspectors_[index_of(side)] = std::make_unique<InspectWorker>(prepared_, host_.wake);
  }
  changed();
}

}  // namespace ps::gui
