#include <filesystem>

#include "gui/frame/menu_bar.h"
#include "gui/widgets/shorten.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr float widest_name = 0.25f;  // of the bar

/// A name as it is; of a long path its end, which says more than its beginning.
std::string short_path(const std::string& name) {
  constexpr std::size_t long_path = 40;
  const std::filesystem::path path(name);
  if (name.size() <= long_path || !path.is_absolute()) return name;
  const std::string end = (".../" / path.parent_path().filename() / path.filename()).string();
  return end.size() <= long_path ? end : path.filename().string();
}

}  // namespace

void MenuBar::scene_menu() {
  const std::string& title = session_.scene().title;
  const std::string shown =
      title.empty() ? std::filesystem::path(session_.document().scene_name).filename().string() : title;
  const float most = ImGui::GetWindowWidth() * widest_name;
  if (!begin_menu("menu/scene", "Scene: " + whole_words(shown, most))) return;
  menu_action(actions_, "open");
  menu_action(actions_, "paste-permalink");
  menu_action(actions_, "scenes");
  menu_action(actions_, "scene-notation");
  if (!session_.loader().recent().empty() && begin_menu("menu/recent", "Recent")) {
    for (const auto& name : std::vector<std::string>(session_.loader().recent())) {
      if (menu_item("recent/" + name, short_path(name))) session_.open(name);
      tooltip(name);
    }
    end_menu();
  }
  menu_action(actions_, "reload");
  ImGui::Separator();
  for (const char* name : {"save-picture", "shot-pictures", "save-slide", "shot-window", "save-scene", "save-screen",
                           "save-bundle", "save-story"})
    menu_action(actions_, name);
  ImGui::Separator();
  for (const char* name : {"picture-b", "drop-picture-b", "copy-permalink", "copy-command"})
    menu_action(actions_, name);
  end_menu();
}

}  // namespace ps::gui
