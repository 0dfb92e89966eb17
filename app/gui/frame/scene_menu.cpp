#include <algorithm>
#include <filesystem>

#include "gui/frame/menu_bar.h"
#include "gui/widgets/widgets.h"
#include "scene/load.h"

namespace ps::gui {
namespace {

/// "cgfs" of "cgfs/shadows".
std::string book_of(const std::string& name) { return name.substr(0, name.find('/')); }

std::string book_title(const std::string& book) {
  if (book == "cgfs") return "Computer Graphics from Scratch";
  if (book == "cgpp") return "Computer Graphics: Principles and Practice";
  if (book == "lab") return "Laboratory";
  if (book == "models") return "Models";
  if (book == "octree") return "Octrees";
  return book;
}

/// Where the first sentence ends: at a full stop before a space, unless it belongs to a short form such as "ch.".
std::size_t sentence_end(const std::string& text) {
  for (auto at = text.find(". "); at != std::string::npos; at = text.find(". ", at + 1)) {
    const std::string before = text.substr(0, at);
    const auto word = before.find_last_of(" (");
    const std::string last = word == std::string::npos ? before : before.substr(word + 1);
    if (last != "ch" && last != "fig" && last != "sec" && last != "p" && last != "e.g" && last != "i.e") return at;
  }
  return std::string::npos;
}

/// How many letters of descriptions a menu has room for, beside its submenus: these would else lie over it, under the
/// pointer that opened them.
std::size_t description_room() {
  constexpr float modes = 250, names = 420, submenu = 460, letter = 8.6f;  // the buttons of the modes are left of it
  constexpr std::size_t fewest = 24, most = 72;
  const float room = (ImGui::GetIO().DisplaySize.x - px(modes + names + submenu)) / px(letter);
  return room < fewest ? 0 : std::min(most, static_cast<std::size_t>(room));
}

/// The first sentence, cut at a maximum length; the tooltip has all.
std::string first_sentence(const std::string& text, std::size_t most) {
  std::string sentence = text.substr(0, sentence_end(text));
  if (const auto part = sentence.find_last_of(":;", most); sentence.size() > most && part != std::string::npos) {
    sentence = sentence.substr(0, part) + ".";
  } else if (sentence.size() > most) {
    const auto space = sentence.rfind(' ', most);
    sentence = sentence.substr(0, space == std::string::npos ? most : space) + " ...";
  } else if (!sentence.empty() && sentence.back() != '.') {
    sentence += '.';
  }
  return sentence;
}

/// A name as it is; of a long path its end, which says more than its beginning.
std::string short_path(const std::string& name) {
  constexpr std::size_t long_path = 40;
  const std::filesystem::path path(name);
  if (name.size() <= long_path || !path.is_absolute()) return name;
  const std::string end = (".../" / path.parent_path().filename() / path.filename()).string();
  return end.size() <= long_path ? end : path.filename().string();
}

}  // namespace

/// The scenes are more than a window has lines for, so what is done with them is above.
void MenuBar::scene_menu() {
  if (!begin_menu("menu/scene", "Scene")) return;
  menu_action(actions_, "open");
  if (!session_.recent().empty() && begin_menu("menu/recent", "Recent")) {
    for (const auto& name : std::vector<std::string>(session_.recent())) {
      if (menu_item("recent/" + name, short_path(name))) session_.open(name);
      tooltip(name);
    }
    end_menu();
  }
  menu_action(actions_, "reload");
  ImGui::Separator();
  for (const char* name : {"save-picture", "save-scene", "save-screen", "save-story"}) menu_action(actions_, name);
  ImGui::Separator();
  for (const char* name : {"picture-b", "drop-picture-b", "copy-permalink", "copy-command"})
    menu_action(actions_, name);
  ImGui::Separator();
  menu_action(actions_, "quit");
  ImGui::Separator();
  static const std::vector<BuiltinScene> scenes = builtin_scenes();
  const std::size_t room = description_room();
  std::string book;
  for (const auto& scene : scenes) {
    if (book_of(scene.name) != book) {
      book = book_of(scene.name);
      const FontScope font(Face::small);
      ImGui::TextDisabled("%s", book_title(book).c_str());
    }
    if (menu_item("scene/" + scene.name, scene.title, room > 0 ? first_sentence(scene.description, room) : "",
                  session_.document().scene_name == scene.name))
      session_.open(scene.name);
    tooltip(scene.description);
  }
  end_menu();
}

}  // namespace ps::gui
