#pragma once
#include <functional>
#include <string>
#include <utility>

#include "gui/session/session.h"
#include "gui/work/thumbnails.h"

namespace ps::gui {

/// The scenes that the program ships with, as pictures over the whole window.
struct SceneGallery {
  /// `wake` may be called from any thread.
  explicit SceneGallery(std::function<void()> wake) : thumbnails(std::move(wake)) {}

  bool open = false;
  bool just_opened = false;
  std::string search;
  int selected = 0;  ///< of those that are found
  Thumbnails thumbnails;
};

void open_scene_gallery(SceneGallery& gallery);

/// Draws it while it is open. A click, or Enter for the selected one, opens a scene; Esc or a click outside closes it.
void scene_gallery(Session& session, SceneGallery& gallery);

/// The full title of the book that a scene's name begins with: "cgfs/shadows" is in "Computer Graphics from Scratch".
std::string book_title(const std::string& scene_name);

}  // namespace ps::gui
