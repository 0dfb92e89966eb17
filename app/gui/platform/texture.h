#pragma once
#include <imgui.h>

#include <cstdint>

#include "base/parallel.h"
#include "image/image.h"

namespace ps::gui {

/// A picture on the graphics card, shown pixel by pixel (no smoothing when enlarged). Main thread only; needs the
/// window's GL context, also when it is destroyed.
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
  void set_shrunk(bool shrunk) const;

  /// Grows whenever any texture changes.
  static std::uint64_t changes();

  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return id_ == 0; }
  /// For ImGui::Image and ImDrawList::AddImage.
  ImTextureID id() const {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): ImGui hands numbers on as pointers
    return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(id_));
  }

 private:
  unsigned id_ = 0;
  int width_ = 0, height_ = 0;
  mutable bool shrunk_ = false;
};

}  // namespace ps::gui
