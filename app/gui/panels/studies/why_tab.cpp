#include "gui/panels/studies/why_tab.h"

#include <imgui.h>

#include "gui/widgets/widgets.h"

namespace ps::gui {

WhyTab::WhyTab(const PanelHost& host)
    : Panel(host, study_facts({.name = "why",
                               .group = ToolGroup::measure,
                               .heading = "WHY",
                               .brief = "Why",
                               .command = "Why: what makes A and B differ",
                               .help = "Which option makes A and B differ, and which pixels float gets wrong."})),
      causes_(host), precision_(host) {}

bool WhyTab::draw(const Context& context) {
  const NameScope scope(facts.name);
  if (!session_.has_scene()) return false;
  static constexpr std::array views{
      Choice{"causes", "Causes", "How much of the difference between A and B each option causes."},
      Choice{"precision", "Precision", "Which pixels differ from a rendering in double."}};
  int shown = static_cast<int>(shown_);
  if (choice("shown", views, shown, {.width = px(180)})) shown_ = static_cast<Shown>(shown);
  same_line_if_room(button_width("Find again"), px(8));
  switch (shown_) {
  case Shown::causes:
    return causes_.draw_part(context.filled);
  case Shown::precision:
    return precision_.draw_part(context.filled);
  }
  return context.filled;
}

void WhyTab::offer(Values& out) {
  causes_.offer(out);
  precision_.offer(out);
}

void WhyTab::update() {
  causes_.update();
  precision_.update();
}

std::string WhyTab::status() const {
  const std::string text = causes_.status();
  return text.empty() ? precision_.status() : text;
}

}  // namespace ps::gui
