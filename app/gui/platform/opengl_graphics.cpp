#include <SDL.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>

#include "gui/platform/graphics.h"
#include "gui/platform/imgui_version.h"
#include "gui/platform/plain_program.h"

namespace ps::gui {
namespace {

GLuint number_of(ImTextureID texture) { return static_cast<GLuint>(texture_number(texture)); }

/// Mesa's software driver has a path several times as fast for textures that do not repeat.
void do_not_repeat(GLuint texture) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

class OpenGlGraphics : public Graphics {
 public:
  OpenGlGraphics(SDL_Window* window, void* context, const char* shader_version)
      : window_(window), context_(context), shader_version_(shader_version) {}
  ~OpenGlGraphics() override { SDL_GL_DeleteContext(context_); }
  OpenGlGraphics(const OpenGlGraphics&) = delete;
  OpenGlGraphics& operator=(const OpenGlGraphics&) = delete;

  GraphicsDriver driver() const override {
    const auto text = [](GLenum name) -> std::string {
      const auto* known = reinterpret_cast<const char*>(glGetString(name));
      return known ? known : "unknown";
    };
    return {"OpenGL " + text(GL_VERSION), text(GL_RENDERER)};
  }

  void attach() override {
    SDL_GL_MakeCurrent(window_, context_);
    SDL_GL_SetSwapInterval(1);
    attach_to_window(window_, context_);
    ImGui_ImplOpenGL3_Init(shader_version_);
  }
  void detach() override {
    ImGui_ImplOpenGL3_Shutdown();
    detach_from_window();
  }
  void begin_frame() override {
    ImGui_ImplOpenGL3_NewFrame();
    do_not_repeat(number_of(ImGui::GetIO().Fonts->TexID));
    begin_window_frame();
  }
  // The cleared colour is the background of the whole window: a filled rectangle of this size would cost drivers that
  // draw by the processor several milliseconds.
  void draw(ImDrawData& data, const ImVec4& paper, WindowSize drawable) override {
    glViewport(0, 0, drawable.width, drawable.height);
    glClearColor(paper.x, paper.y, paper.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(&data);
  }
  Image<Rgb8> read(WindowSize drawable) const override {
    Image<Rgb8> picture(drawable.width, drawable.height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadBuffer(GL_BACK);
    for (int y = 0; y < drawable.height; ++y)  // OpenGL's first row is the lowest
      glReadPixels(0, drawable.height - 1 - y, drawable.width, 1, GL_RGB, GL_UNSIGNED_BYTE, picture.row(y).data());
    return picture;
  }
  void show() override { SDL_GL_SwapWindow(window_); }
  void fonts_changed() override {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
  }

  ImTextureID sized_texture(ImTextureID texture, WindowSize size) override {
    GLuint number = number_of(texture);
    if (number == 0) {
      glGenTextures(1, &number);
      do_not_repeat(number);
      set_filter(GL_NEAREST);
    }
    glBindTexture(GL_TEXTURE_2D, number);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.width, size.height, 0, GL_BGRA, GL_UNSIGNED_BYTE, nullptr);
    return texture_of_number(number);
  }
  void upload(ImTextureID texture, const TileRect& rect, const void* pixels) override {
    glBindTexture(GL_TEXTURE_2D, number_of(texture));
    glTexSubImage2D(GL_TEXTURE_2D, 0, rect.x0, rect.y0, rect.width(), rect.height(), GL_BGRA, GL_UNSIGNED_BYTE, pixels);
  }
  void set_smooth(ImTextureID texture, bool smooth) override {
    glBindTexture(GL_TEXTURE_2D, number_of(texture));
    set_filter(smooth ? GL_LINEAR : GL_NEAREST);
  }
  void destroy_texture(ImTextureID texture) override {
    const GLuint number = number_of(texture);
    glDeleteTextures(1, &number);
  }
  void add_plain(ImDrawList& list, ImTextureID texture, ImVec2 min, ImVec2 max) override {
    add_with(begin_plain, list, texture, min, max);
  }
  bool add_even(ImDrawList& list, ImTextureID texture, ImVec2 min, ImVec2 max) override {
    add_with(begin_even, list, texture, min, max);
    return true;
  }

 private:
  static void add_with(ImDrawCallback begin, ImDrawList& list, ImTextureID texture, ImVec2 min, ImVec2 max) {
    list.AddCallback(begin, nullptr);
    list.AddImage(texture, min, max);
    list.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
  }
  static void set_filter(GLint filter) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  }

  SDL_Window* window_;
  void* context_;
  const char* shader_version_;
};

/// Tries one kind of context; null if the driver refuses it.
SDL_Window* open_with(const std::string& title, WindowSize size, int profile, int major, int minor, void** context) {
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, profile);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, major);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, minor);
  SDL_Window* window =
      SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, size.width, size.height,
                       SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI | SDL_WINDOW_HIDDEN);
  if (!window) return nullptr;
  *context = SDL_GL_CreateContext(window);
  if (*context) return window;
  SDL_DestroyWindow(window);
  return nullptr;
}

}  // namespace

DrawnWindow open_with_opengl(const std::string& title, WindowSize size) {
  SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
  SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
  SDL_GL_SetAttribute(SDL_GL_STENCIL_SIZE, 0);
  DrawnWindow drawn;
  void* context = nullptr;
  const char* shader_version = "#version 150";
  drawn.window = open_with(title, size, SDL_GL_CONTEXT_PROFILE_CORE, 3, 3, &context);
  if (!drawn.window) {
    shader_version = "#version 130";
    drawn.window = open_with(title, size, 0, 3, 0, &context);
  }
  if (drawn.window)
    drawn.graphics = std::make_unique<OpenGlGraphics>(drawn.window, context, shader_version);
  else
    drawn.fault = SDL_GetError();
  return drawn;
}

}  // namespace ps::gui
