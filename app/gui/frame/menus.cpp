#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "gui/frame/app.h"
#include "gui/input/actions.h"
#include "gui/panels/pictures/picture_text.h"
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
  constexpr float names = 420, submenu = 460, letter = 8.6f;
  constexpr std::size_t fewest = 24, most = 72;
  const float room = (ImGui::GetIO().DisplaySize.x - px(names + submenu)) / px(letter);
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

struct LessonEntry {
  std::string book, label, source;
};

/// "Computer Graphics from Scratch" over "chapter 12: Hidden surfaces"; where the source names no chapter, the title
/// alone below the whole source.
LessonEntry lesson_entry(const Lesson& lesson) {
  const auto part = lesson.source.find(", chapter");
  if (part == std::string::npos) return {lesson.source, lesson.title, lesson.source};
  const auto end = std::min(lesson.source.find(';'), lesson.source.size());
  return {lesson.source.substr(0, part),
          fmt::format("{}: {}", lesson.source.substr(part + 2, end - part - 2), lesson.title), lesson.source};
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

/// The scenes are more than a window has lines for, so what is done with them stands above.
void App::scene_menu() {
  if (!begin_menu("menu/scene", "Scene")) return;
  const auto& actions = shell_.actions();
  menu_action(actions, "open");
  if (!session_.recent().empty() && begin_menu("menu/recent", "Recent")) {
    for (const auto& name : std::vector<std::string>(session_.recent())) {
      if (menu_item("recent/" + name, short_path(name))) session_.open(name);
      tooltip(name);
    }
    end_menu();
  }
  menu_action(actions, "reload");
  ImGui::Separator();
  for (const char* name : {"save-picture", "save-scene", "save-screen", "save-story"}) menu_action(actions, name);
  ImGui::Separator();
  for (const char* name : {"picture-b", "drop-picture-b", "copy-permalink", "copy-command"}) menu_action(actions, name);
  ImGui::Separator();
  menu_action(actions, "quit");
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

void App::lesson_menu() {
  if (!begin_menu("menu/lesson", "Lesson")) return;
  std::string book;
  for (const auto& name : lesson_names()) {
    static std::map<std::string, LessonEntry> entries;
    auto [entry, is_new] = entries.try_emplace(name, LessonEntry{"", name, ""});
    if (is_new) {
      try {
        entry->second = lesson_entry(load_lesson(name));
      } catch (const InputError& error) {
        session_.say(Message::Kind::error, error.what());
      }
    }
    const auto& [of, label, source] = entry->second;
    if (of != book) {
      book = of;
      const FontScope font(Face::small);
      ImGui::TextDisabled("%s", book.c_str());
    }
    if (menu_item("lesson/" + name, label, {}, session_.document().lesson == name)) go_to_step(session_, name, 0);
    tooltip(source);
  }
  ImGui::Separator();
  for (const char* name : {"step-next", "step-before", "lesson-after", "lesson-before", "lesson-close"})
    menu_action(shell_.actions(), name);
  end_menu();
}

void App::view_menu() {
  if (!begin_menu("menu/view", "View")) return;
  const auto& actions = shell_.actions();
  const auto items = [&](std::initializer_list<const char*> names) {
    for (const char* name : names) menu_action(actions, name);
    ImGui::Separator();
  };
  items({"undo", "redo", "history"});
  items({"side-by-side", "split", "difference", "only-a", "only-b"});
  items({"fit", "one-to-one", "zoom-in", "zoom-out", "grid", "handles"});
  items({"channel-next", "channel-before"});
  items({"panels", "fullscreen"});
  items({"predict"});
  menu_action(actions, "reset-view");
  menu_action(actions, "fly");
  tooltip(fmt::format("{}, {} and so on turn the camera; {}, {} and so on move it around the scene.",
                      actions.key_text("turn-left"), actions.key_text("turn-up"), actions.key_text("orbit-left"),
                      actions.key_text("orbit-up")));
  ImGui::Separator();
  for (const char* name : {"dark-theme", "larger-type", "smaller-type", "standard-type"}) menu_action(actions, name);
  end_menu();
}

void App::study_menu() {
  if (!begin_menu("menu/study", "Study")) return;
  for (const std::string_view tab : bottom_tabs) {
    if (tab == "chart") ImGui::Separator();  // what follows is about the whole picture
    menu_action(shell_.actions(), "study-" + std::string(tab));
  }
  end_menu();
}

void App::menu_bar() {
  if (!ImGui::BeginMenuBar()) return;
  scene_menu();
  lesson_menu();
  view_menu();
  study_menu();
  if (begin_menu("menu/help", "Help")) {
    if (menu_item("first-look", "A first look", {}, session_.document().lesson == first_look_lesson))
      go_to_step(session_, first_look_lesson, 0);
    for (const char* name : {"help", "palette"}) menu_action(shell_.actions(), name);
    ImGui::Separator();
    if (menu_item("about", "About Pixelscope")) about_open_ = true;
    end_menu();
  }
  // Of a file the name is enough to be read from the last row.
  const std::filesystem::path path(session_.document().scene_name);
  const std::string name = path.is_absolute() ? path.filename().string() : path.string();
  const std::string& title = session_.scene().title;
  const std::string text = title.empty() || title == name ? name : fmt::format("{}   {}", name, title);
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  const float left = std::max(ImGui::GetCursorPosX() + px(24), (ImGui::GetWindowWidth() - width) / 2);
  const float modes = compare_buttons_width();
  if (left + width + px(20) < ImGui::GetWindowWidth() - modes) {
    ImGui::SetCursorPosX(left);
    ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
  }
  compare_buttons(ImGui::GetWindowWidth() - modes);
  ImGui::EndMenuBar();
}

namespace {
struct Mode {
  CompareMode mode;
  const char *name, *label, *help;
};
constexpr std::array modes{
    Mode{CompareMode::side_by_side, "side-by-side", "A | B", "Both pictures side by side."},
    Mode{CompareMode::split, "split", "Split",
         "One picture: A on the left of a divider that you drag, B on the right (X)."},
    Mode{CompareMode::difference, "difference", "Difference", "The difference B - A, multiplied by a gain (D)."}};
}  // namespace

float App::compare_buttons_width() const {
  float width = px(12);
  for (const auto& mode : modes)
    width += ImGui::CalcTextSize(mode.label).x + 2 * ImGui::GetStyle().FramePadding.x + ImGui::GetStyle().ItemSpacing.x;
  return width + px(12);
}

/// How the pictures stand to each other, always in sight: it is what the window is about.
void App::compare_buttons(float left) {
  ImGui::SetCursorPosX(left);
  const NameScope scope("compare");
  for (const auto& mode : modes)
    if (button_on_off(mode.name, mode.label, session_.document().compare == mode.mode,
                      {.tooltip = mode.help, .disabled = {}}))
      session_.navigate([&](Document& document) { document.compare = mode.mode; });
}

void App::file_dialog() {
  const auto answer = files_.draw();
  if (!answer) return;
  switch (answer->purpose) {
  case FilePurpose::open_scene: {
    // A built-in name may be typed as well; the dialog puts its folder before what is not absolute.
    std::error_code error;
    const std::string typed = files_.typed();
    const bool is_file = std::filesystem::exists(answer->path, error);
    session_.open(is_file ? answer->path.string() : typed);
    break;
  }
  case FilePurpose::save_picture:
    save_pictures(answer->path);
    break;
  case FilePurpose::save_scene:
    save_scene_as(answer->path);
    break;
  case FilePurpose::open_picture:
    studies_.chart().setup.reference_file = answer->path.string();
    break;
  case FilePurpose::save_chart:
    save_chart(answer->path);
    break;
  case FilePurpose::save_permalink:
    save_permalink_as(answer->path);
    break;
  case FilePurpose::compare_picture:
    session_.open_picture_b(answer->path);
    break;
  case FilePurpose::save_story:
    save_story_as(answer->path);
    break;
  case FilePurpose::save_space:
    save_drawing(answer->path, space_drawing(session_, space_));
    break;
  case FilePurpose::save_microscope:
    save_drawing(answer->path, microscope_drawing(microscope_));
    break;
  }
}

}  // namespace ps::gui
