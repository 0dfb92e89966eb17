#include <fmt/format.h>

#include "base/check.h"
#include "gui/frame/app.h"
#include "gui/input/actions.h"
#include "options/option.h"

namespace ps::gui {

std::vector<PaletteEntry> App::palette_entries() {
  std::vector<PaletteEntry> entries;
  for (const auto& name : lesson_names()) {
    try {
      entries.push_back(
          {"lesson/" + name, load_lesson(name).title, "lesson", [this, name] { go_to_step(session_, name, 0); }});
    } catch (const InputError&) {
      // The lesson menu says what is wrong with it.
    }
  }
  for (const Option& option : option_table())
    entries.push_back({fmt::format("option/{}", option.key), fmt::format("{}: {}", option.group, option.label),
                       "option", [this, &option] { go_to_option(option); }});
  return entries;
}

void App::go_to_option(const Option& option) {
  point_at_option(options_panel_, option);
  history_.open = false;
  session_.navigate([](Document& document) {
    document.layout.panels = true;
    document.layout.filled.clear();
  });
}

}  // namespace ps::gui
