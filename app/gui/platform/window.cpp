#include "gui/platform/window.h"

#include <SDL.h>
#include <backends/imgui_impl_opengl3.h>
#include <backends/imgui_impl_sdl.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <atomic>
#include <cstdlib>
#include <utility>

#include "gui/input/imgui_keys.h"
#include "gui/platform/display.h"
#include "gui/platform/events.h"
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

[[noreturn]] void fail(const std::string& what) { throw WindowError("The window cannot be opened: " + what); }

/// Tries one kind of context; null if the driver refuses it. The window is hidden yet.
SDL_Window* open_with(const char* title, WindowSize size, int profile, int major, int minor, void** context) {
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, profile);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, major);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, minor);
  SDL_Window* window =
      SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, size.width, size.height,
                       SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI | SDL_WINDOW_HIDDEN);
  if (!window) return nullptr;
  *context = SDL_GL_CreateContext(window);
  if (*context) return window;
  SDL_DestroyWindow(window);
  return nullptr;
}

}  // namespace

Window::Window(const std::string& title, const WindowPlacement& placement) {
  if (!has_display()) fail("there is no display (DISPLAY and WAYLAND_DISPLAY are not set)");
  SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
  SDL_SetHint(SDL_HINT_MOUSE_FOCUS_CLICKTHROUGH, "1");
  SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
  if (SDL_Init(SDL_INIT_VIDEO) != 0) fail(SDL_GetError());
  wake_event = SDL_RegisterEvents(1);
  const WindowSize size = opening_size(placement.size);

  SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
  SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
  SDL_GL_SetAttribute(SDL_GL_STENCIL_SIZE, 0);
  const char* shader_version = "#version 150";
  window_ = open_with(title.c_str(), size, SDL_GL_CONTEXT_PROFILE_CORE, 3, 3, &context_);
  if (!window_) {
    shader_version = "#version 130";
    window_ = open_with(title.c_str(), size, 0, 3, 0, &context_);
  }
  if (!window_) {
    const std::string reason = SDL_GetError();
    SDL_Quit();
    fail("OpenGL 3.0 or newer is needed (" + reason +
         "). Install a newer graphics driver, or render in software: LIBGL_ALWAYS_SOFTWARE=1 pixelscope");
  }
  SDL_SetWindowMinimumSize(window_, 640, 480);
  normal_size_ = NormalSize(size);
  open(placement);
  SDL_GL_MakeCurrent(window_, context_);
  SDL_GL_SetSwapInterval(1);
  SDL_EventState(SDL_DROPFILE, SDL_ENABLE);

  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.MouseDoubleClickTime = 0.4f;
  io.ConfigInputTextCursorBlink = false;  // a blinking cursor would keep an idle window drawing
  ImGui_ImplSDL2_InitForOpenGL(window_, context_);
  map_imgui_keys(io);
  ImGui_ImplOpenGL3_Init(shader_version);
}

Window::~Window() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplSDL2_Shutdown();
  ImGui::DestroyContext();
  SDL_GL_DeleteContext(context_);
  SDL_DestroyWindow(window_);
  SDL_Quit();
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

namespace {

/// Mesa's software driver has a path several times as fast for textures that do not repeat.
void do_not_repeat_fonts() {
  const auto fonts = reinterpret_cast<std::intptr_t>(ImGui::GetIO().Fonts->TexID);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(fonts));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

void Window::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  do_not_repeat_fonts();
  ImGui_ImplSDL2_NewFrame();
  measure();
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(size_.width), static_cast<float>(size_.height)};
}

bool Window::draw_frame(bool will_be_read) {
  const ImVec4& paper = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
  const bool same_paper = std::exchange(shown_paper_, {paper.x, paper.y, paper.z, 1}) == shown_paper_;
  const bool same_textures = std::exchange(shown_textures_, Texture::changes()) == Texture::changes();
  if (shown_.same_again(*ImGui::GetDrawData()) && same_paper && same_textures && !will_be_read) return false;
  glViewport(0, 0, drawable_.width, drawable_.height);
  // The cleared colour is the background of the whole window: a filled rectangle of this size would cost drivers that
  // draw by the processor several milliseconds.
  glClearColor(paper.x, paper.y, paper.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  return true;
}

void Window::show_frame() { SDL_GL_SwapWindow(window_); }

void Window::fonts_changed() {
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
  shown_.forget();
}

Image<Rgb8> Window::screenshot() const {
  Image<Rgb8> picture(drawable_.width, drawable_.height);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadBuffer(GL_BACK);
  for (int y = 0; y < drawable_.height; ++y)  // OpenGL's first row is the lowest
    glReadPixels(0, drawable_.height - 1 - y, drawable_.width, 1, GL_RGB, GL_UNSIGNED_BYTE, picture.row(y).data());
  return picture;
}

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

GraphicsDriver graphics_driver() {
  const auto text = [](GLenum name) -> std::string {
    const auto* known = reinterpret_cast<const char*>(glGetString(name));
    return known ? known : "unknown";
  };
  return {text(GL_VERSION), text(GL_RENDERER)};
}

}  // namespace ps::gui
