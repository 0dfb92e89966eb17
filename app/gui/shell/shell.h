#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "gui/base/content.h"
#include "gui/platform/window_size.h"
#include "image/image.h"

namespace ps::gui {

class Actions;

/// How the window starts.
struct ShellOptions {
  std::string title = "Pixelscope";
  std::optional<double> scale;     ///< --scale; else the remembered one; else guessed from the display
  std::string script;              ///< --script FILE; empty = none
  std::optional<WindowSize> size;  ///< --window-size; else the remembered one, which scripted windows have none of
};

/// The window, its event loop and everything that does not depend on what is shown in it: input, theme, type size,
/// actions (keys, palette, help sheet), remembered state, scripts. One Shell per program.
class Shell {
 public:
  /// Opens the window. Throws WindowError (platform/window.h) if there is no display or no OpenGL, InputError for a
  /// script that cannot be read.
  explicit Shell(const ShellOptions& options);
  ~Shell();
  Shell(const Shell&) = delete;
  Shell& operator=(const Shell&) = delete;

  /// Shows `content` until the window is closed or a script ends it. Returns the exit status: 0, or 1 if an expectation
  /// of the script failed.
  int run(Content& content);

  /// Makes the loop draw a frame soon. May be called from any thread, also after the loop has ended.
  void wake();
  /// Draws again after this many seconds even without an event.
  void wake_after(double seconds);
  /// Ends run() after the current frame.
  void quit(int status = 0);

  /// The table of actions: the content adds its own before run().
  Actions& actions();

  /// Hands over a picture of the window as the next frame draws it. A later wish takes the place of one that waits.
  void take_shot(std::function<void(Image<Rgb8>)> take);
  void set_fullscreen(bool on);
  bool fullscreen() const;
  /// Whether it was started in a size that was asked for.
  bool has_asked_size() const;
  void set_title(const std::string& title);
  std::string clipboard() const;
  void set_clipboard(const std::string& text);

  /// Text remembered from one start to the next, by key ("layout/left"); empty if there is none. Scripted windows start
  /// without memory and do not store any, unless XDG_STATE_HOME is set for them.
  std::string remembered(const std::string& key) const;
  /// Whether what is remembered now will be there at the next start.
  bool remembers() const;
  void remember(const std::string& key, std::string value);
  /// The same for a list with an entry on each line, to which other windows may add.
  void remember_lines(const std::string& key, std::string lines);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ps::gui
