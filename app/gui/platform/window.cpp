#include "gui/platform/window.h"

#include <SDL.h>
#include <fmt/format.h>
#include <imgui.h>

#include <atomic>
#include <cstdlib>
#include <utility>

#include "base/spelling.h"
#include "gui/platform/display.h"
#include "gui/platform/events.h"
#include "gui/platform/imgui_version.h"
#include "gui/platform/keyboard.h"
#include "gui/platform/texture.h"

namespace ps::gui {
namespace {

std::atomic<bool> wake_waiting{false};
std::atomic<Uint32> wake_event{0};

bool has_display() {
  const auto set = [](const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
  };
  return set("DISPLAY") || set("WAYLAND_DISPLAY") || set("SDL_VIDEODRIVER");
}

/// Where no display answers, SDL goes on to drivers that show nothing, unless it was told to use one of them.
bool shows_nothing(const std::string& driver) {
  const char* wanted = std::getenv("SDL_VIDEODRIVER");
  return (driver == "offscreen" || driver == "dummy" || driver == "evdev") &&
         (!wanted || std::string(wanted).find(driver) == std::string::npos);
}

[[noreturn]] void fail(const std::string& what) { throw WindowError("The window cannot be opened: " + what); }

}  // namespace

Window::Window(const std::string& title, const WindowPlacement& placement) {
  if (!has_display()) fail("there is no display (DISPLAY and WAYLAND_DISPLAY are not set)");
  SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
  SDL_SetHint(SDL_HINT_MOUSE_FOCUS_CLICKTHROUGH, "1");
  SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
  if (SDL_Init(SDL_INIT_VIDEO) != 0) fail(SDL_GetError());
  if (shows_nothing(SDL_GetCurrentVideoDriver())) {
    SDL_Quit();
    const auto quoted = [](const char* name) {
      const char* value = std::getenv(name);
      return value && *value ? fmt::format(" {}='{}'", name, shown_start(value)) : std::string();
    };
    fail(fmt::format("no display answers at{}{}", quoted("DISPLAY"), quoted("WAYLAND_DISPLAY")));
  }
  wake_event = SDL_RegisterEvents(1);
  const WindowSize size = opening_size(placement.size);

  DrawnWindow drawn = open_with_opengl(title, size);
  if (!drawn.window) drawn = open_with_sdl(title, size, drawn.fault);
  if (!drawn.window) {
    SDL_Quit();
    fail(drawn.fault);
  }
  window_ = drawn.window;
  graphics_ = std::move(drawn.graphics);
  SDL_SetWindowMinimumSize(window_, 640, 480);
  normal_size_ = NormalSize(size);
  open(placement);
  read_keyboard(window_);
  SDL_EventState(SDL_DROPFILE, SDL_ENABLE);

  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.MouseDoubleClickTime = 0.4f;
  io.ConfigInputTextCursorBlink = false;  // a blinking cursor would keep an idle window drawing
  graphics_->attach();
  begin_tracked_input(io);
}

Window::~Window() {
  graphics_->detach();
  ImGui::DestroyContext();
  graphics_.reset();
  SDL_DestroyWindow(window_);
  // SDL_Quit() is left out: a worker may wake the window as it closes, by a message on a connection of SDL's own. If
  // the X server reads it after the window has gone, closing that connection ends the program with exit status 1.
}

bool Window::wait_events(double seconds, const std::function<void(const InputEvent&)>& sink) {
  bool any = false;
  SDL_Event event;
  const int milliseconds = seconds >= 1e6 ? -1 : static_cast<int>(seconds * 1000 + 0.999);
  int got = milliseconds == 0  ? SDL_PollEvent(&event)
            : milliseconds < 0 ? SDL_WaitEvent(&event)
                               : SDL_WaitEventTimeout(&event, milliseconds);
  while (got) {
    any = true;
    if (event.type == SDL_KEYMAPCHANGED) read_keyboard(window_);
    if (event.type == SDL_KEYDOWN && event.key.repeat == 0) follow_keyboard(window_);
    if (event.type == wake_event)
      wake_waiting = false;
    else
      sink(translated(event));
    if (event.type == SDL_WINDOWEVENT) shown_.forget();  // the window may have been covered, or have another size
    got = SDL_PollEvent(&event);
  }
  leave_room_for_decoration();
  note_size();
  return any;
}

void Window::wake() {
  if (wake_event == 0 || wake_waiting.exchange(true)) return;
  SDL_Event event{};
  event.type = wake_event;
  if (SDL_PushEvent(&event) <= 0) wake_waiting = false;
}

void Window::begin_frame() {
  graphics_->begin_frame();
  measure();
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(size_.width), static_cast<float>(size_.height)};
}

bool Window::draw_frame(bool will_be_read) {
  const ImVec4& paper = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
  const bool same_paper = std::exchange(shown_paper_, {paper.x, paper.y, paper.z, 1}) == shown_paper_;
  const bool same_textures = std::exchange(shown_textures_, Texture::changes()) == Texture::changes();
  if (shown_.same_again(*ImGui::GetDrawData()) && same_paper && same_textures && !will_be_read) return false;
  graphics_->draw(*ImGui::GetDrawData(), paper, drawable_);
  return true;
}

void Window::show_frame() { graphics_->show(); }

void Window::fonts_changed() {
  graphics_->fonts_changed();
  shown_.forget();
}

Image<Rgb8> Window::screenshot() const { return graphics_->read(drawable_); }

WindowPoint Window::pointer() const {
  int x = 0, y = 0, left = 0, top = 0;
  SDL_GetGlobalMouseState(&x, &y);
  SDL_GetWindowPosition(window_, &left, &top);
  return {static_cast<float>(x - left), static_cast<float>(y - top)};
}

void Window::set_title(const std::string& title) { SDL_SetWindowTitle(window_, title.c_str()); }

std::string Window::clipboard() const {
  char* text = SDL_GetClipboardText();
  std::string result = text ? text : "";
  SDL_free(text);
  return result;
}

void Window::set_clipboard(const std::string& text) { SDL_SetClipboardText(text.c_str()); }

unsigned Window::id() const { return SDL_GetWindowID(window_); }

GraphicsDriver graphics_driver() { return Graphics::current()->driver(); }

}  // namespace ps::gui
