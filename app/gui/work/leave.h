#pragma once

namespace ps::gui {

/// Ends the program with this exit status in 0.2 s if it has not ended by itself: what it waits for, a call of a
/// graphics driver or a compiler, may take as long as it likes. For the end of main(), when all that is kept is saved.
void leave_soon(int status);

}  // namespace ps::gui
