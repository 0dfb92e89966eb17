#include "gui/panels/studies/why_tab.h"

namespace ps::gui {

WhyTab::WhyTab(const PanelHost& host)
    : StudyParts(host, {.name = "why",
                        .group = ToolGroup::measure,
                        .heading = "Why",
                        .brief = "Why",
                        .command = "Why: what makes A and B differ",
                        .help = "Which option makes A and B differ, and which pixels float gets wrong."}),
      causes_(host), missing_(host), precision_(host) {
  const auto is_file = [this] { return session_.picture_b() != nullptr; };
  add({{{"causes", "Causes", "How much of the difference between A and B each option causes."},
        causes_,
        [=] { return !is_file(); }},
       {{"missing", "What is missing?", "What the picture file in B's place has less or otherwise than A."},
        missing_,
        is_file},
       {{"precision", "Precision", "Which pixels differ from a rendering in double."}, precision_}});
}

}  // namespace ps::gui
