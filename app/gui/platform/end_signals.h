#pragma once

namespace ps::gui {

/// SIGTERM and SIGHUP, with which a logout, a shutdown or a closed terminal end the program. From this call on they
/// wake the window's loop, which asks end_signal(), instead of ending the program at once; a second one does end it. To
/// be called before any other thread is started. One that was ignored from the beginning (nohup) stays ignored.
void watch_end_signals();

/// The signal that came; 0 = none yet.
int end_signal();

}  // namespace ps::gui
