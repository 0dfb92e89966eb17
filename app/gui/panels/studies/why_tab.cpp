#include "gui/panels/studies/why_tab.h"

#include <imgui.h>

#include "gui/widgets/widgets.h"

namespace ps::gui {

WhyTab::WhyTab(const PanelHost& host)
    : Panel(host, study_facts({.name = "why",
                               .group = ToolGroup::measure,
                               .heading = "Why",
                               .brief = "Why",
                               .command = "Why: what makes A and B differ",
                               .help = "Which option makes A and B differ, and which pixels float gets wrong."})),
      causes_(host), missing_(host), precision_(host) {}

bool WhyTab::draw(const Context& context) {
  const NameScope scope(facts.name);
  if (!session_.has_scene()) return false;
  const bool file = session_.picture_b() != nullptr;
  const std::array views{
      file ? Choice{"missing", "What is missing?", "What the picture file in B's place has less or otherwise than A."}
           : Choice{"causes", "Causes", "How much of the difference between A and B each option causes."},
      Choice{"precision", "Precision", "Which pixels differ from a rendering in double."}};
  int shown = static_cast<int>(shown_);
  if (choice("shown", views, shown, {.width = px(file ? 250 : 180)})) shown_ = static_cast<Shown>(shown);
  same_line_if_room(button_width("Find again"), px(8));
  switch (shown_) {
  case Shown::causes:
    return file ? missing_.draw_part(context.filled) : causes_.draw_part(context.filled);
  case Shown::precision:
    return precision_.draw_part(context.filled);
  }
  return context.filled;
}

void WhyTab::offer(Values& out) {
  causes_.offer(out);
  missing_.offer(out);
  precision_.offer(out);
}

void WhyTab::update() {
  causes_.update();
  missing_.update();
  precision_.update();
}

std::string WhyTab::status() const {
  for (const StudyFrame* part : std::initializer_list<const StudyFrame*>{&causes_, &missing_})
    if (std::string text = part->status(); !text.empty()) return text;
  return precision_.status();
}

}  // namespace ps::gui
