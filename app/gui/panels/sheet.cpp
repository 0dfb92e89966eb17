#include "gui/panels/sheet.h"

#include "gui/base/record.h"
#include "gui/widgets/overlay.h"

namespace ps::gui {

bool Sheet::draw(const Context&) {
  open_ = open_ && has_subject();
  if (!open_) return false;
  const NameScope names(facts.name);
  const Overlay overlay(("##" + std::string(facts.name)).c_str(), look_.size, just_opened_);
  if (*look_.title && overlay_title(look_.title)) open_ = false;
  draw_sheet();
  if (overlay.left()) open_ = false;
  return false;
}

void Sheet::offer(Values& out) {
  out.offer(std::string(facts.name) + "/open", [this] { return open_; });
}

}  // namespace ps::gui
