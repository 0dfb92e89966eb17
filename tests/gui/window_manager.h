#pragma once
#include <sys/types.h>

namespace ps::test {

/// A small window manager (openbox with tests/gui/files/openbox.xml) on the display of the tests, while this lives.
/// Alt+M maximises the window and gives its size back, Alt+I minimises it.
class WindowManager {
 public:
  WindowManager();
  ~WindowManager();
  WindowManager(const WindowManager&) = delete;
  WindowManager& operator=(const WindowManager&) = delete;

  /// What it and its users need is installed.
  static bool available();
  bool runs() const { return process_ > 0; }

 private:
  pid_t process_ = -1;
};

}  // namespace ps::test
