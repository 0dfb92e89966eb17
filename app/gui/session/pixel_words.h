#pragma once
#include <string>

#include "gui/session/session.h"

namespace ps::gui {

/// "x 540, y 340": column and row from the top left; in a lesson, which may be about the book's canvas, its way of
/// counting too: "x 540, y 340   book (240, -41)".
std::string pixel_words(const Session& session, Vec2i pixel);

}  // namespace ps::gui
