#include "gui/panels/scenes/scene_gallery.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "base/check.h"
#include "base/word_search.h"
#include "gui/input/imgui_keys.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/overlay.h"
#include "gui/widgets/widgets.h"
#include "scene/load.h"

namespace ps::gui {
namespace {

constexpr double picture_width = 152, picture_height = 152;  // at scale 1
constexpr double gap = 16, text_lines = 2;

bool pressed(Key key) { return ImGui::IsKeyPressed(imgui_key(key), true); }

/// The picture of a scene by its number in the list; nullptr while it is being made.
const Texture* picture_of(SceneGallery& gallery, std::size_t number) {
  const int width = static_cast<int>(px(picture_width)), height = static_cast<int>(px(picture_height));
  return gallery.thumbnails.find(
      number, width, height, [name = builtin_scenes()[number].name, width, height](Prepared&, Progress& progress) {
        Prepared own;  // what a scene needs for its picture is not kept
        return thumbnail_of_a(open_document(name, load_scene(name)), width, height, own, progress);
      });
}

/// One scene: its picture over its title. Answers whether it was clicked.
bool tile(SceneGallery& gallery, std::size_t number, bool selected, bool reveal) {
  const BuiltinScene& scene = builtin_scenes()[number];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = theme().font(Face::small)->FontSize + px(3);
  const ImVec2 size{px(picture_width), px(picture_height) + static_cast<float>(text_lines) * line + px(6)};
  const bool clicked = ImGui::InvisibleButton(scene.name.c_str(), size);
  controls().record(scene.name, scene.title);
  if (reveal) ImGui::SetScrollHereY();
  if (!ImGui::IsItemVisible()) return clicked;
  auto& list = *ImGui::GetWindowDrawList();
  const Palette& p = palette();
  const ImVec2 end{at.x + size.x, at.y + size.y}, picture_end{end.x, at.y + px(picture_height)};
  if (selected || ImGui::IsItemHovered())
    list.AddRectFilled({at.x - px(5), at.y - px(5)}, {end.x + px(5), end.y + px(3)},
                       colour_u32(selected ? p.selection : p.field_hover), px(4));
  list.AddRectFilled(at, picture_end, colour_u32(p.panel));
  if (const Texture* picture = picture_of(gallery, number); picture && !picture->empty()) {
    const auto w = static_cast<float>(picture->width()), h = static_cast<float>(picture->height());
    const ImVec2 corner{std::round((at.x + end.x - w) / 2), std::round((at.y + picture_end.y - h) / 2)};
    list.AddImage(picture->id(), corner, {corner.x + w, corner.y + h});
  }
  {
    const FontScope font(Face::small);
    list.PushClipRect({at.x, picture_end.y}, end, true);
    draw_lines({at.x, picture_end.y + px(4)}, in_lines(scene.title, size.x), p.text);
    list.PopClipRect();
  }
  tooltip(scene.title + " (" + scene.name + ")\n" + scene.description);
  return clicked;
}

/// By arrow keys, through the tiles as they lie in rows of `columns`.
void move_selection(SceneGallery& gallery, int columns, int count) {
  const int before = gallery.selected;
  if (pressed(Key::right)) ++gallery.selected;
  if (pressed(Key::left)) --gallery.selected;
  if (pressed(Key::down)) gallery.selected += columns;
  if (pressed(Key::up)) gallery.selected -= columns;
  if (gallery.selected < 0 || gallery.selected >= count) gallery.selected = before;
  gallery.selected = std::clamp(gallery.selected, 0, std::max(count - 1, 0));
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
std::string tiles(SceneGallery& gallery, const std::vector<std::size_t>& found) {
  std::string chosen;
  const float room = ImGui::GetContentRegionAvail().x - px(8);
  const int columns = std::max(1, static_cast<int>((room + px(gap)) / px(picture_width + gap)));
  const int before = gallery.selected;
  move_selection(gallery, columns, static_cast<int>(found.size()));
  std::string book;
  int column = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::string title = book_title(builtin_scenes()[found[i]].name);
    if (title != book) {
      book = title;
      column = 0;
      const FontScope bold(Face::bold);
      ImGui::Dummy({0, px(4)});
      ImGui::TextUnformatted(book.c_str());
      ImGui::Dummy({0, px(2)});
    }
    if (column > 0) ImGui::SameLine(static_cast<float>(column) * px(picture_width + gap) + px(6));
    if (column == 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + px(6));
    const bool selected = static_cast<int>(i) == gallery.selected;
    if (tile(gallery, found[i], selected, selected && gallery.selected != before))
      chosen = builtin_scenes()[found[i]].name;
    column = (column + 1) % columns;
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
  std::string chosen = tiles(gallery, found);
  ImGui::EndChild();
  if (!gallery.just_opened && pressed(Key::enter) && !found.empty())
    chosen = builtin_scenes()[found[static_cast<std::size_t>(gallery.selected)]].name;
  if (!chosen.empty()) session.open(chosen);
  if (window.left() || !chosen.empty()) gallery.open = false;
  std::set<std::uint64_t> ids;
  for (std::size_t i = 0; i < builtin_scenes().size(); ++i) ids.insert(i);
  gallery.thumbnails.update(ids);
}

}  // namespace ps::gui
