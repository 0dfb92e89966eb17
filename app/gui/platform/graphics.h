#pragma once
#include <imgui.h>

#include <memory>
#include <string>

#include "base/parallel.h"
#include "gui/platform/window_size.h"
#include "image/image.h"

struct SDL_Window;

namespace ps::gui {

/// How the driver that draws the window names itself; "unknown" where it does not.
struct GraphicsDriver {
  std::string version, renderer;
};

/// The back end that draws into the window: OpenGL, or SDL's own renderer where there is none. Main thread only.
class Graphics {
 public:
  Graphics();
  virtual ~Graphics();
  Graphics(const Graphics&) = delete;
  Graphics& operator=(const Graphics&) = delete;

  /// The back end of the open window; nullptr without one.
  static Graphics* current();

  virtual GraphicsDriver driver() const = 0;

  // Frames. attach() comes after Dear ImGui's context, detach() before its end.
  virtual void attach() = 0;
  virtual void detach() = 0;
  virtual void begin_frame() = 0;
  /// Draws over the whole back buffer; `paper` is the background.
  virtual void draw(ImDrawData& data, const ImVec4& paper, WindowSize drawable) = 0;
  /// The back buffer after draw().
  virtual Image<Rgb8> read(WindowSize drawable) const = 0;
  virtual void show() = 0;           ///< the back buffer
  virtual void fonts_changed() = 0;  ///< the font atlas was rebuilt

  // Textures of four bytes for each pixel: blue, green, red, 255. A texture is shown without smoothing at first.
  /// Makes one, or gives one that is there another size; its pixels are undefined.
  virtual ImTextureID sized_texture(ImTextureID texture, WindowSize size) = 0;
  virtual void upload(ImTextureID texture, const TileRect& rect, const void* pixels) = 0;
  virtual void set_smooth(ImTextureID texture, bool smooth) = 0;
  virtual void destroy_texture(ImTextureID texture) = 0;
  /// ImDrawList::AddImage without a tint and without blending.
  virtual void add_plain(ImDrawList& list, ImTextureID texture, ImVec2 min, ImVec2 max) = 0;
  /// The same for an enlarged and smooth texture: each pixel has one colour, and is mixed with the next one only where
  /// both share a pixel of the window, so that all are equally wide. False: it cannot be done, and the list is as
  /// before.
  virtual bool add_even(ImDrawList& /*list*/, ImTextureID /*texture*/, ImVec2 /*min*/, ImVec2 /*max*/) { return false; }
};

/// A window with what draws into it, hidden yet.
struct DrawnWindow {
  SDL_Window* window = nullptr;
  std::unique_ptr<Graphics> graphics;
  std::string fault;  ///< why there is none
};

/// With OpenGL 3.3 core or, if that is not to be had, 3.0.
DrawnWindow open_with_opengl(const std::string& title, WindowSize size);
/// With SDL's renderer, which needs no OpenGL and draws by the processor if it must. `why` is reported beside its name.
DrawnWindow open_with_sdl(const std::string& title, WindowSize size, const std::string& why);

}  // namespace ps::gui
