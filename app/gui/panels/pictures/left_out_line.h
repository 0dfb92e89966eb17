#pragma once
#include <string>
#include <vector>

#include "frame/left_out.h"
#include "gui/panels/pictures/picture_transform.h"
#include "gui/session/session.h"

namespace ps::gui {

/// The parts of a scene that a renderer leaves out, joined: names with commas, sentences a line each.
struct LeftOutTexts {
  std::string names, sentences;
};
LeftOutTexts left_out_texts(const std::vector<LeftOut>& all);

/// The parts of the scene that the renderer of a side leaves out, in a row below its picture, with the settings that
/// show it as buttons. Text that does not fit is shortened; the tooltip has all of it. Answers what is left of the row.
Area left_out_line(Session& session, Side side, const Area& row);

}  // namespace ps::gui
