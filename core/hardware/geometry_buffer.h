#pragma once
#include <array>

#include "hardware/framebuffer.h"

namespace ps::hardware {

/// What deferred shading keeps of each pixel: floats that fragment.glsl writes and deferred.glsl reads. Depth buffer
/// and channels are those of the picture.
class GeometryBuffer {
 public:
  static constexpr std::size_t most_textures = 5;

  /// For pictures of this target, which has one sample per pixel and outlives it.
  explicit GeometryBuffer(const Framebuffer& target);
  ~GeometryBuffer();
  GeometryBuffer(const GeometryBuffer&) = delete;
  GeometryBuffer& operator=(const GeometryBuffer&) = delete;

  /// Draws go here from now on.
  void bind() const;
  /// No pixel shows a surface.
  void clear() const;
  /// Makes the textures those of the units from `first_unit` on, in the order of the outputs of fragment.glsl.
  void bind_textures(int first_unit) const;

 private:
  void release();
  FramebufferShape shape_;
  unsigned framebuffer_ = 0;
  std::array<unsigned, most_textures> textures_{};
};

}  // namespace ps::hardware
