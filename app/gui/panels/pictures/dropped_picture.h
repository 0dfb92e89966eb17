#pragma once
#include <filesystem>

#include "gui/panels/sheet.h"
#include "scene/object_surface.h"

namespace ps::gui {

/// A picture file that was dropped on the window, until the user has said what it is for: to be compared with A, in
/// B's place, or to be a texture of an object.
class DroppedPicture final : public Sheet {
 public:
  explicit DroppedPicture(const PanelHost& host) : Sheet(host, "dropped", {"What is this picture for?", {520, 0}}) {}
  /// `object` is the one under the pointer, or of the picked pixel, or -1. In a scene whose objects take no texture the
  /// picture goes to B at once.
  void ask(const std::filesystem::path& file, int object);

 protected:
  /// Another scene may have come meanwhile.
  bool has_subject() override { return takes_texture(session_.scene(), static_cast<std::size_t>(object_)); }
  void draw_sheet() override;

 private:
  void put_on();
  void object_choice();

  std::filesystem::path file_;
  int object_ = -1;    ///< index of the one that would get it as a texture
  bool plain_ = true;  ///< the object's colour becomes white, so that the picture is seen as it is
};

}  // namespace ps::gui
