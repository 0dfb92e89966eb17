#pragma once
#include <vector>

#include "base/parallel.h"
#include "frame/frame.h"
#include "math/has_nan.h"
#include "raster/base/fragment.h"
#include "raster/base/multisample.h"
#include "raster/setup/draw_stage.h"

namespace ps::raster {

/// What deferred shading keeps of a pixel: the fragment that it shows.
template <class Real>
struct Winner {
  PrimitiveRef triangle;
  Fragment<Real> fragment;
  bool any = false;
};

/// One tile of the picture while it is drawn: the frame's own pixels, and a depth buffer of its own.
template <class Real>
class Target {
 public:
  /// `origin` is the array position of the frame's own first pixel: not (0, 0) where the frame holds only a part of the
  /// picture, which then must not have channels.
  Target(Frame& frame, const TileRect& rect, const Settings& settings, Channel channels, Vec2i origin = {0, 0})
      : frame_(frame), rect_(rect), channels_(channels), origin_(origin) {
    const std::size_t pixels = static_cast<std::size_t>(rect.width()) * static_cast<std::size_t>(rect.height());
    samples_ = settings.draw == Draw::filled ? sample_count(settings.multisampling) : 1;
    if (settings.visibility == Visibility::depth_buffer)
      depth_.assign(pixels * static_cast<std::size_t>(samples_) + vector_room,
                    empty_depth<Real>(make_depth_code(settings, 1)));
    if (defers_shading(settings)) winners_.resize(pixels);
    if (has_passes(settings) && (settings.early_depth || settings.light_passes == LightPasses::many))
      shaded_.assign(pixels, 0);
    if (samples_ > 1) fill_samples();
    nan_written_ = has_nan(colour(rect.x0, rect.y0));  // a background of NaN
  }

  const TileRect& rect() const { return rect_; }
  /// The depth buffer's value at a pixel of the tile. Only with visibility = depth-buffer.
  Real& depth(int column, int row) {
    return depth_[static_cast<std::size_t>(row - rect_.y0) * static_cast<std::size_t>(rect_.width()) +
                  static_cast<std::size_t>(column - rect_.x0)];
  }
  int samples() const { return samples_; }
  /// The same for sub-sample `sample` of a pixel, with multisampling.
  Real& sample_depth(int column, int row, int sample) { return depth_[sample_index(column, row, sample)]; }
  Vec3<Real>& sample_colour(int column, int row, int sample) {
    return sample_colours_[sample_index(column, row, sample)];
  }
  /// The fragment that deferred shading found for a pixel.
  Winner<Real>& winner(int column, int row) { return winners_[pixel_index(column, row)]; }
  /// How often a pixel was shaded after visibility was known: at equal depths only the first fragment is.
  std::uint16_t& times_shaded(int column, int row) { return shaded_[pixel_index(column, row)]; }

  /// With multisampling, makes each pixel the mean of its sub-samples. Sums of pairs, so that equal ones stay as they
  /// are.
  void resolve() {
    if (samples_ == 1) return;
    for (int row = rect_.y0; row < rect_.y1; ++row)
      for (int column = rect_.x0; column < rect_.x1; ++column) {
        std::array<Vec3<Real>, 8> sum;
        for (int s = 0; s < samples_; ++s) sum[static_cast<std::size_t>(s)] = sample_colour(column, row, s);
        for (int count = samples_; count > 1; count /= 2)
          for (int s = 0; s < count / 2; ++s) {
            const auto k = static_cast<std::size_t>(s);
            sum[k] = sum[2 * k] + sum[2 * k + 1];
          }
        set_colour(column, row, sum[0] / static_cast<Real>(samples_));
      }
  }

  /// Reports colours that were written into the frame itself: did one of them have a NaN?
  void note_nan(bool nan) { nan_written_ = nan_written_ || nan; }
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
  std::size_t pixel_index(int column, int row) const {
    return static_cast<std::size_t>(row - rect_.y0) * static_cast<std::size_t>(rect_.width()) +
           static_cast<std::size_t>(column - rect_.x0);
  }
  std::size_t sample_index(int column, int row, int sample) const {
    return pixel_index(column, row) * static_cast<std::size_t>(samples_) + static_cast<std::size_t>(sample);
  }
  void fill_samples() {
    sample_colours_.resize(static_cast<std::size_t>(rect_.width()) * static_cast<std::size_t>(rect_.height()) *
                           static_cast<std::size_t>(samples_));
    for (int row = rect_.y0; row < rect_.y1; ++row)
      for (int column = rect_.x0; column < rect_.x1; ++column)
        for (int s = 0; s < samples_; ++s) sample_colour(column, row, s) = colour(column, row);
  }

  Frame& frame_;
  TileRect rect_;
  Channel channels_;
  Vec2i origin_;
  bool nan_written_ = false;
  static constexpr std::size_t vector_room = 16;  ///< the fast path reads and writes back whole vectors
  std::vector<Real> depth_;
  int samples_ = 1;
  std::vector<Vec3<Real>> sample_colours_;  ///< with multisampling: samples of a pixel follow each other, as in depth_
  std::vector<Winner<Real>> winners_;
  std::vector<std::uint16_t> shaded_;
};

/// The code that gives the pixels of a new frame the background's colour, depth and id.
enum class Background { filled, left_to_tiles };

/// Gives the rectangle the background's colour, and its depth and id where the frame has them.
void fill_background(const Scene& scene, const TileRect& rect, Frame& frame);

/// A frame of the background's colour with the wanted channels, each holding its value for the background.
Frame make_frame(const Scene& scene, const View& view, const Settings& settings, Channel channels,
                 Background background = Background::filled);

}  // namespace ps::raster
