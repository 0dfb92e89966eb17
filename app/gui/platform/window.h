#pragma once
#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "gui/base/window_point.h"
#include "gui/input/event.h"
#include "gui/platform/frame_memory.h"
#include "gui/platform/graphics.h"
#include "gui/platform/normal_size.h"
#include "gui/platform/window_size.h"
#include "image/image.h"

struct SDL_Window;

namespace ps::gui {

/// No display, or no way to draw into a window. what() is one line for people.
class WindowError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How a window opens, and how it was left.
struct WindowPlacement {
  WindowSize size;         ///< when it is not maximised; {0, 0} = 90 % of the display. Larger than the display: clamped
  bool maximised = false;  ///< covers the display apart from its panels
};

/// The window with what draws into it (OpenGL or, where there is none, SDL) and Dear ImGui's back ends.
class Window {
 public:
  Window(const std::string& title, const WindowPlacement& placement);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Waits for an event for at most `seconds` (0: only looks; 1e6 and more: for ever) and hands every waiting event to
  /// `sink`, except wake-ups. Answers whether there was any event or wake-up.
  bool wait_events(double seconds, const std::function<void(const InputEvent&)>& sink);
  /// Ends a wait_events() on the main thread. From any thread.
  static void wake();

  void begin_frame();  ///< the ImGui back ends' NewFrame
  /// Draws ImGui's draw data into the back buffer. Not if that would show what the window shows already, unless the
  /// caller will read the buffer; answers whether it was drawn.
  bool draw_frame(bool will_be_read);
  /// The picture that draw_frame() left and show_frame() has not shown yet.
  Image<Rgb8> screenshot() const;
  void show_frame();     ///< swaps
  void fonts_changed();  ///< the font atlas was rebuilt

  /// Where the display's pointer is, from the window's top left.
  WindowPoint pointer() const;
  /// The size that it really has, as of begin_frame().
  WindowSize size() const { return size_; }
  /// Clamped to the display; moved so that all of it is seen.
  void resize(WindowSize size);
  /// Where the upper left corner of what is inside its frame is on the desktop.
  std::array<int, 2> position() const;
  int display_lines() const;  ///< height of its display
  /// Whether a person may see it: neither minimised nor on another desktop.
  bool visible() const;
  /// Leaving full screen gives back size, place and state.
  void set_fullscreen(bool on);
  bool fullscreen() const { return full_screen_ != FullScreen::off; }
  bool maximised() const;
  /// How the next start should open it: never the size of a full screen.
  WindowPlacement placement();
  void set_title(const std::string& title);
  std::string clipboard() const;
  void set_clipboard(const std::string& text);
  unsigned id() const;

 private:
  enum class FullScreen {
    off,
    by_manager,  ///< the window manager does it
    by_hand      ///< there is none that can: moved and resized
  };
  struct Place {
    int x = 0, y = 0;
    WindowSize size;
  };
  Place place() const;
  void move_to(const Place& place);
  void open(const WindowPlacement& placement);
  void cover_display();
  void leave_room_for_decoration();
  void measure();
  void note_size();
  bool normal() const;

  SDL_Window* window_ = nullptr;
  std::unique_ptr<Graphics> graphics_;
  WindowSize size_, drawable_;
  NormalSize normal_size_;
  FullScreen full_screen_ = FullScreen::off;
  bool opening_ = true;  // its decoration may not be known yet
  std::chrono::steady_clock::time_point opened_;
  bool covers_ = false;         // maximised by hand
  bool was_maximised_ = false;  // before it became full screen
  Place before_;                // it became full screen by hand
  FrameMemory shown_;
  std::uint64_t shown_textures_ = 0;  // Texture::changes() then
  std::array<float, 4> shown_paper_{};
};

/// The driver of the window that is open. Main thread only.
GraphicsDriver graphics_driver();

}  // namespace ps::gui
