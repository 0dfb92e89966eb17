#pragma once
#include <array>

#include "math/vec.h"

namespace ps::hardware {

/// Where fragments report of themselves: four 32-bit floats for each sample, of the size of the picture, so that pixels
/// and samples lie where the picture has them. Only one pixel of it is ever used.
class StoryTarget {
 public:
  struct Shape {
    int width = 0, height = 0;
    int samples = 1;  ///< of a pixel
    bool operator==(const Shape&) const = default;
  };

  explicit StoryTarget(const Shape& shape);
  ~StoryTarget();
  StoryTarget(const StoryTarget&) = delete;
  StoryTarget& operator=(const StoryTarget&) = delete;

  const Shape& shape() const { return shape_; }
  /// Draws go here from now on, all samples of a pixel.
  void bind() const;
  /// Draws go to a picture with one sample for each pixel.
  void bind_single() const;
  /// Sets the pixel to zeros, wherever draws go.
  static void clear();
  /// What was drawn at the pixel by bind_single().
  Vec4f read_single(Vec2i pixel) const;
  /// What was drawn at the pixel after bind() and clear() to one of its samples alone. The mean of all samples is then
  /// a power of two smaller, which costs no bits.
  Vec4f read_sample(Vec2i pixel) const;

 private:
  struct Picture {
    unsigned framebuffer = 0, buffer = 0;
  };
  void make(Picture& picture, int samples) const;
  void release();

  Shape shape_;
  Picture drawn_, single_;  ///< the same where a pixel has one sample
};

}  // namespace ps::hardware
