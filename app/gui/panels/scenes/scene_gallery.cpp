#include "gui/panels/scenes/scene_gallery.h"

#include <imgui.h>

#include <set>
#include <vector>

#include "base/check.h"
#include "base/word_search.h"
#include "gui/platform/imgui_version.h"
#include "gui/widgets/picture_tiles.h"
#include "gui/widgets/widgets.h"
#include "scene/load.h"

namespace ps::gui {
namespace {

/// The picture of a scene by its number in the list; nullptr while it is being made.
const Texture* picture_of(Thumbnails& thumbnails, std::size_t number, int width, int height) {
  return thumbnails.find(number, width, height,
                         [name = builtin_scenes()[number].name, width, height](Prepared&, Progress& progress) {
                           Prepared own;  // what a scene needs for its picture is not kept
                           return thumbnail_of_a(open_document(name, load_scene(name)), width, height, own, progress);
                         });
}

std::vector<std::size_t> found_scenes(const std::string& search) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < builtin_scenes().size(); ++i) {
    const BuiltinScene& scene = builtin_scenes()[i];
    if (has_words(search, {scene.name, scene.title, scene.description, scene.keywords, book_title(scene.name)}))
      found.push_back(i);
  }
  return found;
}

}  // namespace

std::string book_title(const std::string& scene_name) {
  std::string book = scene_name.substr(0, scene_name.find('/'));
  if (book == "cgfs") return "Computer Graphics from Scratch";
  if (book == "cgpp") return "Computer Graphics: Principles and Practice";
  if (book == "lab") return "Laboratory";
  if (book == "models") return "Models";
  if (book == "octree") return "Octrees";
  return book;
}

/// The tiles of what was found, a heading over each book. Answers the one that was chosen.
std::string SceneGallery::tiles(const std::vector<std::size_t>& found) {
  std::string chosen, book;
  PictureTiles pictures(selected_, found.size(), {});
  for (const std::size_t number : found) {
    const BuiltinScene& scene = builtin_scenes()[number];
    const std::string title = book_title(scene.name);
    if (title != book) pictures.heading(title);
    book = title;
    if (pictures.tile(
            {.name = scene.name,
             .title = scene.title,
             .note = {},
             .tooltip = scene.title + " (" + scene.name + ")\n" + scene.description,
             .picture = [&](int width, int height) { return picture_of(thumbnails_, number, width, height); }}))
      chosen = scene.name;
  }
  return chosen;
}

void SceneGallery::add_actions(Actions& actions) {
  ActionGroup(actions, "Scene").add("scenes", "Gallery of scenes", "Ctrl+Shift+O", [this] {
    open();
    search_.clear();
    selected_ = 0;
  });
}

void SceneGallery::draw_sheet() {
  {
    const FontScope title(Face::heading);
    ImGui::TextUnformatted("Scenes");
  }
  ImGui::SameLine(px(140));
  if (just_opened_) ImGui::SetKeyboardFocusHere();
  if (search_box("search", search_, "Search: z-fighting, glass, shadow ...", {.width = px(340)})) selected_ = 0;
  const std::vector<std::size_t> found = found_scenes(search_);
  ImGui::SameLine();
  value_text("count", found.empty() ? "No scene has these words."
                                    : std::to_string(found.size()) + (found.size() == 1 ? " scene" : " scenes"));
  if (close_at_end()) open_ = false;
  ImGui::Dummy({0, px(2)});
  ImGui::BeginChild("##tiles");
  std::string chosen = tiles(found);
  ImGui::EndChild();
  if (!just_opened_ && key_pressed(Key::enter) && !found.empty())
    chosen = builtin_scenes()[found[static_cast<std::size_t>(selected_)]].name;
  if (!chosen.empty()) {
    session_.open(chosen);
    open_ = false;
  }
  std::set<std::uint64_t> ids;
  for (std::size_t i = 0; i < builtin_scenes().size(); ++i) ids.insert(i);
  thumbnails_.update(ids);
}

}  // namespace ps::gui
