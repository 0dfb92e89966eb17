#pragma once
#include <string>
#include <vector>

#include "gui/panels/sheet.h"
#include "gui/widgets/overlay.h"
#include "gui/work/thumbnails.h"

namespace ps::gui {

/// The scenes that the program ships with, as pictures over the whole window.
class SceneGallery final : public Sheet {
 public:
  explicit SceneGallery(const PanelHost& host) : Sheet(host, "scenes", {"", whole_window}), thumbnails_(host.wake) {}
  void add_actions(Actions& actions) override;
  bool busy() const override { return open_ && thumbnails_.busy(); }

 protected:
  /// A click, or Enter for the selected one, opens a scene.
  void draw_sheet() override;

 private:
  std::string tiles(const std::vector<std::size_t>& found);

  std::string search_;
  int selected_ = 0;  ///< of those that are found
  Thumbnails thumbnails_;
};

/// The full title of the book that a scene's name begins with: "cgfs/shadows" is in "Computer Graphics from Scratch".
std::string book_title(const std::string& scene_name);

}  // namespace ps::gui
