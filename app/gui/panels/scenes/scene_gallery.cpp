#include "gui/panels/scenes/scene_gallery.h"

#include <imgui.h>

#include <set>
#include <vector>

#include "base/check.h"
#include "base/word_search.h"
#include "gui/platform/imgui_version.h"
#include "gui/widgets/overlay.h"
#include "gui/widgets/picture_tiles.h"
#include "gui/widgets/widgets.h"
#include "scene/load.h"

namespace ps::gui {
namespace {

/// The picture of a scene by its number in the list; nullptr while it is being made.
const Texture* picture_of(SceneGallery& gallery, std::size_t number, int width, int height) {
  return gallery.thumbnails.find(
      number, width, height, [name = builtin_scenes()[number].name, width, height](Prepared&, Progress& progress) {
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

/// The tiles of what was found, a heading over each book. Answers the one that was chosen.
std::string scene_tiles(SceneGallery& gallery, const std::vector<std::size_t>& found) {
  std::string chosen, book;
  PictureTiles tiles(gallery.selected, found.size(), {});
  for (const std::size_t number : found) {
    const BuiltinScene& scene = builtin_scenes()[number];
    const std::string title = book_title(scene.name);
    if (title != book) tiles.heading(title);
    book = title;
    if (tiles.tile({.name = scene.name,
                    .title = scene.title,
                    .note = {},
                    .tooltip = scene.title + " (" + scene.name + ")\n" + scene.description,
                    .picture = [&](int width, int height) { return picture_of(gallery, number, width, height); }}))
      chosen = scene.name;
  }
  return chosen;
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

void open_scene_gallery(SceneGallery& gallery) {
  gallery.open = gallery.just_opened = true;
  gallery.search.clear();
  gallery.selected = 0;
}

void scene_gallery(Session& session, SceneGallery& gallery) {
  if (!gallery.open) return;
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const Overlay window("##scenes", {px(20), px(20)}, {display.x - px(40), display.y - px(40)},
                       ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove, gallery.just_opened);
  const NameScope names("scenes");
  {
    const FontScope title(Face::heading);
    ImGui::TextUnformatted("Scenes");
  }
  ImGui::SameLine(px(140));
  if (gallery.just_opened) ImGui::SetKeyboardFocusHere();
  if (search_box("search", gallery.search, "Search: z-fighting, glass, shadow ...", {.width = px(340)}))
    gallery.selected = 0;
  const std::vector<std::size_t> found = found_scenes(gallery.search);
  ImGui::SameLine();
  value_text("count", found.empty() ? "No scene has these words."
                                    : std::to_string(found.size()) + (found.size() == 1 ? " scene" : " scenes"));
  ImGui::SameLine(ImGui::GetWindowWidth() - px(24) - px(84));
  if (button("close", "Close", Emphasis::plain, {.width = px(84)})) gallery.open = false;
  ImGui::Dummy({0, px(2)});
  ImGui::BeginChild("##tiles");
  std::string chosen = scene_tiles(gallery, found);
  ImGui::EndChild();
  if (!gallery.just_opened && key_pressed(Key::enter) && !found.empty())
    chosen = builtin_scenes()[found[static_cast<std::size_t>(gallery.selected)]].name;
  if (!chosen.empty()) session.open(chosen);
  if (window.left() || !chosen.empty()) gallery.open = false;
  std::set<std::uint64_t> ids;
  for (std::size_t i = 0; i < builtin_scenes().size(); ++i) ids.insert(i);
  gallery.thumbnails.update(ids);
}

}  // namespace ps::gui
