#pragma once
#include <vector>

#include "base/parallel.h"
#include "raster/depth_test.h"
#include "raster/shade_fragment.h"
#include "render/frame.h"

namespace ps::raster {

/// One tile of the picture while it is drawn: the frame's own pixels, and a depth buffer of its own.
template <class Real>
class Target {
 public:
  /// `origin` is the array position of the frame's own first pixel: not (0, 0) where the frame holds only a part of the
  /// picture, which then must not have channels.
  Target(Frame& frame, const TileRect& rect, const Settings& settings, Channel channels, Vec2i origin = {0, 0})
      : frame_(frame), rect_(rect), channels_(channels), origin_(origin) {
    if (settings.visibility == Visibility::depth_buffer)
      depth_.assign(static_cast<std::size_t>(rect.width()) * static_cast<std::size_t>(rect.height()) + vector_room,
                    empty_depth<Real>(make_depth_code(settings, 1)));
    nan_written_ = has_nan(colour(rect.x0, rect.y0));  // a background of NaN
  }

  const TileRect& rect() const { return rect_; }
  /// The depth buffer's value at a pixel of the tile. Only with visibility = depth-buffer.
  Real& depth(int column, int row) {
    return depth_[static_cast<std::size_t>(row - rect_.y0) * static_cast<std::size_t>(rect_.width()) +
                  static_cast<std::size_t>(column - rect_.x0)];
  }
  /// Writes many pixels, named by their index in the picture. Only where the frame holds all of it, in float.
  void set_colours(const ShadeBatch& batch) {
    Vec3f* pixels = frame_.colour.pixels().data();
    bool nan = false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
      const Vec3f colour(batch.red[i], batch.green[i], batch.blue[i]);
      nan = nan || has_nan(Vec3<Real>(colour));
      pixels[batch.pixels[i]] = colour;
    }
    nan_written_ = nan_written_ || nan;
  }
  bool wants(Channel channel) const { return has(channels_, channel); }
  Frame& frame() { return frame_; }

  Vec3<Real> colour(int column, int row) const {
    if constexpr (std::is_same_v<Real, double>)
      return frame_.colour_double.row(row - origin_.y)[static_cast<std::size_t>(column - origin_.x)];
    else
      return frame_.colour.row(row - origin_.y)[static_cast<std::size_t>(column - origin_.x)];
  }
  void set_colour(int column, int row, const Vec3<Real>& colour) {
    nan_written_ = nan_written_ || has_nan(colour);
    frame_.colour.row(row - origin_.y)[static_cast<std::size_t>(column - origin_.x)] = Vec3f(colour);
    if constexpr (std::is_same_v<Real, double>)
      frame_.colour_double.row(row - origin_.y)[static_cast<std::size_t>(column - origin_.x)] = colour;
  }

  /// Pixels of the tile with a NaN in any channel of their colour. Only looks where a NaN was written or has been
  /// there from the start.
  std::uint64_t count_nan_pixels() const {
    if (!nan_written_) return 0;
    std::uint64_t count = 0;
    for (int row = rect_.y0; row < rect_.y1; ++row)
      for (int column = rect_.x0; column < rect_.x1; ++column) count += has_nan(colour(column, row)) ? 1u : 0u;
    return count;
  }

 private:
  static bool has_nan(const Vec3<Real>& c) { return c.x != c.x || c.y != c.y || c.z != c.z; }

  Frame& frame_;
  TileRect rect_;
  Channel channels_;
  Vec2i origin_;
  bool nan_written_ = false;
  static constexpr std::size_t vector_room = 16;  ///< the fast path reads and writes back whole vectors
  std::vector<Real> depth_;
};

/// A frame of the background's colour with the wanted channels, each holding what "nothing is seen" means in it.
Frame make_frame(const Scene& scene, const View& view, const Settings& settings, Channel channels);

}  // namespace ps::raster
