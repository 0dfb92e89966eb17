// The tabs below the pictures, so that menu, palette and keys find them.
#include <string>

#include "gui/app/app.h"
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
  struct Tab {
    std::string_view name, label;
  };
  constexpr std::array<Tab, bottom_tabs.size()> tabs{{{"space", "Space: the scene from outside"},
                                                      {"microscope", "Microscope: the pixel at panel size"},
                                                      {"pixels", "Pixels: the worst ones"},
                                                      {"listing", "Listing: a routine with its values"},
                                                      {"vertex", "Vertex: a corner's way to the canvas"},
                                                      {"chart", "Chart: time against error"},
                                                      {"stability", "Stability: where methods fail"},
                                                      {"needs", "Needs: what the scene can do without"},
                                                      {"why", "Why: what makes A and B differ"},
                                                      {"timings", "Timings: times and counts"}}};
  for (const Tab& tab : tabs)
    shell_.actions().add({.name = "study-" + std::string(tab.name),
                          .label = std::string(tab.label),
                          .group = "Study",
                          .run = [this, name = tab.name] { show_tab(name); },
                          .enabled = [this] { return session_.has_scene(); }});
}

}  // namespace ps::gui
