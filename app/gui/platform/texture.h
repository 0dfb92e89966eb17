#pragma once
#include <imgui.h>

#include <cstdint>

#include "base/parallel.h"
#include "image/image.h"

namespace ps::gui {

/// A picture where the window's graphics can draw it, shown pixel by pixel (no smoothing when enlarged). Main thread
/// only; while the window is open.
class Texture {
 public:
  Texture() = default;
  ~Texture();
  Texture(Texture&& other) noexcept;
  Texture& operator=(Texture&& other) noexcept;

  /// Replaces the whole picture.
  void upload(const Image<Rgb8>& picture);
  /// Replaces one rectangle of a picture of the same size as the last upload.
  void upload(const Image<Rgb8>& picture, const TileRect& rect);

  /// Whether it is shown smaller than it is, and so its pixels are mixed. One choice for all places where a frame shows
  /// it: drivers that draw by the processor are several times as fast where it does not depend on the size.
  void set_shrunk(bool shrunk) const { set_smooth(shrunk); }

  /// Grows whenever any texture changes.
  static std::uint64_t changes();

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return !id_; }
  /// For ImGui::Image and ImDrawList::AddImage.
  ImTextureID id() const { return id_; }

 private:
  friend void add_plain_texture(ImDrawList& list, const Texture& texture, ImVec2 min, ImVec2 max);
  void set_smooth(bool smooth) const;

  ImTextureID id_{};
  int width_ = 0, height_ = 0;
  mutable bool smooth_ = false;
};

/// Adds a texture to the list as ImDrawList::AddImage does, but drawn as it is: without a tint and without blending.
/// Its pixels are equally wide also where it is enlarged a little, and not by a whole number.
void add_plain_texture(ImDrawList& list, const Texture& texture, ImVec2 min, ImVec2 max);

}  // namespace ps::gui
