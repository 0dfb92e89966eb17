#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "gui/base/window_point.h"
#include "gui/platform/frame_memory.h"
#include "image/image.h"

union SDL_Event;
struct SDL_Window;

namespace ps::gui {

/// No display, or no OpenGL. what() is one line for people.
class WindowError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct WindowSize {
  int width = 1280, height = 800;
  bool operator==(const WindowSize&) const = default;
};

/// The window with its OpenGL context (3.3 core; if that is not to be had, 3.0) and Dear ImGui's two back ends.
class Window {
 public:
  Window(const std::string& title, WindowSize size);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Waits for an event for at most `seconds` (0: only looks; 1e6 and more: for ever) and hands every waiting event to
  /// `sink`, except wake-ups. Answers whether there was any event or wake-up.
  bool wait_events(double seconds, const std::function<void(const SDL_Event&)>& sink);
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
  WindowSize size() const;
  WindowSize drawable_size() const;
  void resize(WindowSize size);
  int display_lines() const;  ///< height of its display
  bool minimised() const;
  void set_fullscreen(bool on);
  bool fullscreen() const { return fullscreen_; }
  void set_title(const std::string& title);
  std::string clipboard() const;
  void set_clipboard(const std::string& text);
  unsigned id() const;

 private:
  SDL_Window* window_ = nullptr;
  void* context_ = nullptr;
  bool fullscreen_ = false;
  FrameMemory shown_;
  std::uint64_t shown_textures_ = 0;  // Texture::changes() then
  std::array<float, 4> shown_paper_{};
};

}  // namespace ps::gui
