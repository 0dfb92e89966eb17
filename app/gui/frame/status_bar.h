#pragma once
#include <string>

#include "gui/panels/pictures/pictures_panel.h"
#include "gui/session/session.h"

namespace ps::gui {

/// The pixel under the mouse: both names of the pixel, its value and its object. Empty if the mouse is over no picture.
std::string hover_text(Session& session, const PicturesState& pictures);

/// When long work began; the bar shows work only after a while, so that quick work does not flicker.
struct StatusBarState {
  double busy_since = -1;
  bool news_cut = false;  ///< the newest information does not fit into the line
  float bars_height = 0;  ///< that the messages below take from the regions, window pixels
};

/// The text of the line where the mouse is over no picture. A task stays beside what is under the mouse if both fit.
struct StatusHint {
  enum class Kind { help, task };
  Kind kind = Kind::help;
  std::string text;
};

/// The line at the lower edge: what is under the mouse, or `hint` otherwise; news that pass by themselves; and the
/// progress of long work with cancel.
void status_bar(Session& session, const PicturesState& pictures, StatusBarState& state, const StatusHint& hint);

/// Warnings and errors, which stay until they are read, one below the other, ending at `bottom` (window pixels). What
/// room they take is in `state`, so that they cover no panel.
void message_bars(Session& session, StatusBarState& state, float left, float right, float bottom);

}  // namespace ps::gui
