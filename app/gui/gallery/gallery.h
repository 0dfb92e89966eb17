#pragma once
#include <memory>

#include "gui/base/content.h"

namespace ps::gui {

class Shell;

/// All controls on one page (`pixelscope --widget-gallery`): for judging them by eye and for testing them without a
/// scene.
std::unique_ptr<Content> make_gallery(Shell& shell);

}  // namespace ps::gui
