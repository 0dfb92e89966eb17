#include "gui/panels/studies/why_tab.h"

#include <imgui.h>

#include "gui/widgets/widgets.h"

namespace ps::gui {

bool WhyTab::draw(Session& session, bool filled) {
  if (!session.has_scene()) return false;
  static constexpr std::array views{
      Choice{"causes", "Causes", "How much of the difference between A and B each option causes."},
      Choice{"precision", "Precision", "Which pixels differ from a rendering in double."}};
  int shown = static_cast<int>(shown_);
  if (choice("shown", views, shown, {.width = px(180)})) shown_ = static_cast<Shown>(shown);
  same_line_if_room(button_width("Find again"), px(8));
  switch (shown_) {
  case Shown::causes:
    return causes.draw(session, filled);
  case Shown::precision:
    return precision.draw(session, filled);
  }
  return filled;
}

}  // namespace ps::gui
