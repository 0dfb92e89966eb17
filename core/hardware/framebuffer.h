#pragma once
#include <array>
#include <optional>

#include "frame/frame.h"
#include "scene/scene.h"

namespace ps::hardware {

/// In what a framebuffer keeps depths.
enum class DepthStore { float32, unorm24, unorm16 };

/// What a framebuffer must have room for.
struct FramebufferShape {
  int width = 0, height = 0;
  DepthStore depth = DepthStore::float32;
  bool stencil = false;   ///< 8 bits, not beside a depth of 16 bits
  bool channels = false;  ///< more than the colour
  int samples = 1;        ///< of a pixel
  bool operator==(const FramebufferShape&) const = default;
};

/// Pictures to draw into: linear colours as 32-bit floats, what fragment.glsl writes besides, and a depth buffer. Row 0
/// is the top row of the picture, so that a driver gives samples on an edge to the same triangle as the rasterizer.
class Framebuffer {
 public:
  explicit Framebuffer(const FramebufferShape& shape);
  ~Framebuffer();
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  const FramebufferShape& shape() const { return shape_; }
  /// Draws go here from now on.
  void bind() const;
  /// Fills the colours with the background, the depth buffer with `depth`, and all else with "nothing is seen".
  void clear(const Vec3d& background, float depth) const;
  /// Attaches the depth buffer and the channels to the framebuffer that is bound, those as colours from number `first`
  /// on; returns how many.
  int share(int first) const;
  /// Makes each pixel's colour the mean of its samples. Nothing to do with one sample.
  void resolve() const;
  /// Draws go to the resolved pictures from now on.
  void bind_resolved() const;
  /// The same for one pixel's colour.
  void resolve_pixel(Vec2i pixel) const;
  /// One pixel's colour and the fourth number beside it, as resolved.
  Vec4f read_pixel(Vec2i pixel) const;
  /// One pixel's number in the depth buffer, from 0 to 1. Only with one sample.
  float read_depth(Vec2i pixel) const;
  /// One pixel's number in the stencil buffer. Only with one sample.
  int read_stencil(Vec2i pixel) const;
  /// The depth buffer as a texture with several samples per pixel. Nothing with one sample, and where the driver has no
  /// such textures of depths.
  std::optional<unsigned> depth_samples() const;
  /// Visible triangle, its normal and weights (0, 1, 2) as textures with several samples per pixel. Only with several
  /// samples and channels.
  unsigned channel_samples(std::size_t channel) const { return drawn_.textures[channel]; }
  /// Copies what was drawn, and resolved, to the frame's channels.
  void read(Frame& frame) const;

 private:
  static constexpr std::size_t most_pictures = 4;
  struct Pictures {
    unsigned framebuffer = 0, depth = 0;
    std::array<unsigned, most_pictures> buffers{};
    // In place of `depth` and of all buffers but the first, where there are several samples.
    unsigned depth_texture = 0;
    std::array<unsigned, most_pictures - 1> textures{};
  };
  void make(Pictures& pictures, int samples) const;
  bool attach_texture(unsigned& texture, unsigned format, unsigned place, int samples) const;
  void release();
  std::size_t count() const { return shape_.channels ? most_pictures : 1; }

  FramebufferShape shape_;
  Pictures drawn_;     ///< what is drawn into
  Pictures resolved_;  ///< what is read, where `drawn_` has several samples
};

}  // namespace ps::hardware
