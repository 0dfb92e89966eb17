#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "gui/session/session.h"

namespace ps::gui {

/// A picture file that was dropped on the window, until the user has said what it is for.
struct DroppedPicture {
  std::filesystem::path file;  ///< empty = none
  int object = -1;             ///< index of the one that would get it as a texture
  bool plain = true;           ///< the object's colour becomes white, so that the picture is seen as it is
  bool shown = false;          ///< the question has been drawn
};

/// Asks what a dropped picture is for: to be compared with A, in B's place, or to be a texture of an object. `object`
/// is the one under the pointer, or of the picked pixel, or -1. In a scene whose objects take no texture it goes to B
/// at once.
void ask_about_picture(Session& session, DroppedPicture& state, const std::filesystem::path& file, int object);

/// The question, in the middle of the window; absent while none is asked. Esc is left to the caller.
void dropped_picture(Session& session, DroppedPicture& state);

}  // namespace ps::gui
