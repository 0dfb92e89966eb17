#pragma once

namespace ps::gui {

/// Asks for another frame after this many seconds (0: at once) although nothing may happen until then; for tooltips
/// that appear late and for things that move. Call while drawing. The earliest wish of a frame counts.
void redraw_after(double seconds);
/// For the shell: the earliest wish since the last call, in seconds; negative if there was none.
double take_redraw_wish();

}  // namespace ps::gui
