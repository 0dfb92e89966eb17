// The tabs below the pictures, so that menu, palette and keys find them.
#include <string>

#include "gui/frame/app.h"
#include "gui/frame/bottom_tab_table.h"
#include "gui/input/actions.h"

namespace ps::gui {

void App::show_tab(std::string_view tab) {
  if (filling() != "bottom") fill({});
  toggle_bottom(true);
  session_.navigate([&](Document& document) {
    document.layout.panels = true;
    document.layout.bottom_tab = tab;
  });
}

void App::add_study_actions() {
  for (std::size_t i = 0; i < bottom_tabs.size(); ++i)
    shell_.actions().add({.name = "study-" + std::string(bottom_tabs[i]),
                          .label = std::string(bottom_tab_table[i].command),
                          .group = "Study",
                          .run = [this, name = bottom_tabs[i]] { show_tab(name); },
                          .enabled = [this] { return session_.has_scene(); }});
}

}  // namespace ps::gui
