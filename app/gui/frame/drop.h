#pragma once
#include <optional>
#include <string>

#include "gui/base/window_point.h"
#include "gui/panels/pictures/dropped_picture.h"
#include "gui/panels/pictures/pictures_panel.h"

namespace ps::gui {

/// A file was dropped on the window, at this place. A picture that carries a permalink opens what it shows, any other
/// one asks what it is for; everything else is opened as a scene.
void take_dropped_file(Session& session, const PicturesState& pictures, DroppedPicture& dropped,
                       const std::string& path, WindowPoint at);

}  // namespace ps::gui
