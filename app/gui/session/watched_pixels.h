#pragma once
#include <array>
#include <optional>
#include <vector>

#include "image/image.h"
#include "math/vec.h"

namespace ps::gui {

/// A pixel's colours in A and B each time they changed, the newest last.
struct WatchedPixel {
  Vec2i pixel{0, 0};
  std::vector<std::array<std::optional<Rgb8>, 2>> values;  ///< absent where a picture does not have the pixel
};

/// Pixels whose values are followed while options change.
class WatchedPixels {
 public:
  static constexpr std::size_t most_pixels = 12, most_values = 64;

  bool contains(Vec2i pixel) const;
  /// Watches a pixel, or no longer. Without effect where there are most_pixels already.
  void toggle(Vec2i pixel);
  /// Notes the values that the pictures have now; call it when they are complete. Only changes are kept.
  void note(const Image<Rgb8>& a, const Image<Rgb8>& b);
  const std::vector<WatchedPixel>& all() const { return pixels_; }

 private:
  std::vector<WatchedPixel> pixels_;
};

}  // namespace ps::gui
