#include <SDL.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "gui/platform/graphics.h"
#include "gui/platform/imgui_version.h"

namespace ps::gui {
namespace {

// NOLINTNEXTLINE(performance-no-int-to-ptr): the number is the pointer that Dear ImGui was given
SDL_Texture* texture_of(ImTextureID texture) { return reinterpret_cast<SDL_Texture*>(texture_number(texture)); }

/// Dear ImGui's triangles drawn by SDL_RenderGeometry, for machines without OpenGL.
class SdlGraphics : public Graphics {
 public:
  SdlGraphics(SDL_Window* window, SDL_Renderer* renderer, std::string why)
      : window_(window), renderer_(renderer), why_(std::move(why)) {}
  ~SdlGraphics() override { SDL_DestroyRenderer(renderer_); }  // and all of its textures
  SdlGraphics(const SdlGraphics&) = delete;
  SdlGraphics& operator=(const SdlGraphics&) = delete;

  GraphicsDriver driver() const override {
    SDL_RendererInfo info{};
    const bool known = SDL_GetRendererInfo(renderer_, &info) == 0 && info.name;
    return {"no OpenGL: " + why_, std::string("SDL renderer '") + (known ? info.name : "unknown") + "'"};
  }

  void attach() override {
    attach_to_window(window_, renderer_);
    ImGuiIO& io = ImGui::GetIO();
    io.BackendRendererName = "pixelscope_sdl_geometry";
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  }
  void detach() override {
    ImGui::GetIO().Fonts->SetTexID({});
    detach_from_window();
  }
  void begin_frame() override {
    for (SDL_Texture* texture : to_destroy_) SDL_DestroyTexture(texture);
    to_destroy_.clear();
    if (!ImGui::GetIO().Fonts->TexID) upload_fonts();
    begin_window_frame();
  }
  void draw(ImDrawData& data, const ImVec4& paper, WindowSize drawable) override {
    const auto level = [](float share) { return static_cast<Uint8>(std::lround(share * 255)); };
    SDL_RenderSetClipRect(renderer_, nullptr);
    SDL_SetRenderDrawColor(renderer_, level(paper.x), level(paper.y), level(paper.z), 255);
    SDL_RenderClear(renderer_);
    SDL_RenderSetScale(renderer_, static_cast<float>(drawable.width) / data.DisplaySize.x,
                       static_cast<float>(drawable.height) / data.DisplaySize.y);
    for (int i = 0; i < data.CmdListsCount; ++i) draw_list(*data.CmdLists[i], data);
    SDL_RenderSetClipRect(renderer_, nullptr);
    SDL_RenderSetScale(renderer_, 1, 1);
  }
  Image<Rgb8> read(WindowSize drawable) const override {
    Image<Rgb8> picture(drawable.width, drawable.height);
    const SDL_Rect all{0, 0, drawable.width, drawable.height};
    SDL_RenderReadPixels(renderer_, &all, SDL_PIXELFORMAT_RGB24, picture.row(0).data(),
                         drawable.width * static_cast<int>(sizeof(Rgb8)));
    return picture;
  }
  void show() override { SDL_RenderPresent(renderer_); }
  void fonts_changed() override {
    destroy_texture(ImGui::GetIO().Fonts->TexID);
    upload_fonts();
  }

  ImTextureID sized_texture(ImTextureID texture, WindowSize size) override {
    if (texture) destroy_texture(texture);
    return made(SDL_PIXELFORMAT_ARGB8888, size, SDL_ScaleModeNearest);  // as a number: blue is its lowest byte
  }
  void upload(ImTextureID texture, const TileRect& rect, const void* pixels) override {
    const SDL_Rect place{rect.x0, rect.y0, rect.width(), rect.height()};
    SDL_UpdateTexture(texture_of(texture), &place, pixels, rect.width() * 4);
  }
  void set_smooth(ImTextureID texture, bool smooth) override {
    SDL_SetTextureScaleMode(texture_of(texture), smooth ? SDL_ScaleModeLinear : SDL_ScaleModeNearest);
  }
  // What this frame has drawn so far may name it.
  void destroy_texture(ImTextureID texture) override {
    if (texture) to_destroy_.push_back(texture_of(texture));
  }
  void add_plain(ImDrawList& list, ImTextureID texture, ImVec2 min, ImVec2 max) override {
    list.AddImage(texture, min, max);
  }

 private:
  ImTextureID made(Uint32 format, WindowSize size, SDL_ScaleMode scaling) {
    SDL_Texture* texture = SDL_CreateTexture(renderer_, format, SDL_TEXTUREACCESS_STATIC, size.width, size.height);
    SDL_SetTextureBlendMode(texture, SDL_BLENDMODE_BLEND);
    SDL_SetTextureScaleMode(texture, scaling);
    return texture_of_number(reinterpret_cast<std::uintptr_t>(texture));
  }
  void upload_fonts() {
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    const ImTextureID texture = made(SDL_PIXELFORMAT_RGBA32, {width, height}, SDL_ScaleModeLinear);
    SDL_UpdateTexture(texture_of(texture), nullptr, pixels, width * 4);
    ImGui::GetIO().Fonts->SetTexID(texture);
  }
  void draw_list(const ImDrawList& list, const ImDrawData& data) const {
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.UserCallback) {
        if (command.UserCallback != ImDrawCallback_ResetRenderState) command.UserCallback(&list, &command);
        continue;
      }
      const auto low = [](float at) { return static_cast<int>(std::floor(at)); };
      const auto high = [](float at) { return static_cast<int>(std::ceil(at)); };
      const int x0 = low(command.ClipRect.x - data.DisplayPos.x), y0 = low(command.ClipRect.y - data.DisplayPos.y);
      const SDL_Rect clip{x0, y0, high(command.ClipRect.z - data.DisplayPos.x) - x0,
                          high(command.ClipRect.w - data.DisplayPos.y) - y0};
      if (clip.w <= 0 || clip.h <= 0) continue;
      SDL_RenderSetClipRect(renderer_, &clip);
      const ImDrawVert* vertices = list.VtxBuffer.Data + command.VtxOffset;
      constexpr int stride = sizeof(ImDrawVert);
      SDL_RenderGeometryRaw(renderer_, texture_of(command.GetTexID()), &vertices->pos.x, stride,
                            reinterpret_cast<const SDL_Color*>(&vertices->col), stride, &vertices->uv.x, stride,
                            list.VtxBuffer.Size - static_cast<int>(command.VtxOffset),
                            list.IdxBuffer.Data + command.IdxOffset, static_cast<int>(command.ElemCount),
                            sizeof(ImDrawIdx));
    }
  }

  SDL_Window* window_;
  SDL_Renderer* renderer_;
  std::string why_;
  std::vector<SDL_Texture*> to_destroy_;  // once the frame that may show them is over
};

}  // namespace

DrawnWindow open_with_sdl(const std::string& title, WindowSize size, const std::string& why) {
  DrawnWindow drawn;
  drawn.window = SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, size.width,
                                  size.height, SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI | SDL_WINDOW_HIDDEN);
  SDL_Renderer* renderer = drawn.window ? SDL_CreateRenderer(drawn.window, -1, 0) : nullptr;
  if (renderer) {
    drawn.graphics = std::make_unique<SdlGraphics>(drawn.window, renderer, why);
    return drawn;
  }
  drawn.fault = SDL_GetError();
  if (drawn.window) SDL_DestroyWindow(drawn.window);
  drawn.window = nullptr;
  return drawn;
}

}  // namespace ps::gui
