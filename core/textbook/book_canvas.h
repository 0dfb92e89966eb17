#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/parallel.h"
#include "image/image.h"
#include "math/vec.h"

namespace ps {

/// A pixel that was put on the canvas: its place in the part that the canvas holds, and its colour from 0 to 255.
struct CanvasWrite {
  Vec2i place{0, 0};
  Vec3d colour{0, 0, 0};
};

/// The book's canvas: positions are counted from the centre, y up; colours go from 0 to 255. It may hold a part of the
/// picture only; what is put elsewhere is dropped.
class BookCanvas {
 public:
  /// With `progress` (which must outlive it) drawing throws Cancelled once a stop is requested.
  BookCanvas(int width, int height, const TileRect& part, const Vec3d& background, const Progress* progress = nullptr)
      : width_(width), height_(height), reach_(3.0 * std::max(width, height)), part_(part),
        colours_(part.width(), part.height(), background), nearest_(part.width(), part.height(), 0),
        progress_(progress) {}

  /// The positions that it holds: x from left() to below right(), y from bottom() to below top().
  int left() const { return part_.x0 - width_ / 2; }
  int right() const { return part_.x1 - width_ / 2; }
  int bottom() const { return height_ - height_ / 2 - part_.y1; }
  int top() const { return height_ - height_ / 2 - part_.y0; }

  /// Fractions of a position are dropped, toward the centre.
  void put_pixel(double x, double y, const Vec3d& colour) {
    if (progress_) progress_->check();
    const Vec2i place = place_of(x, y);
    if (!colours_.contains(place.x, place.y)) return;
    colours_.at(place.x, place.y) = colour;
    if (writes_) note(place, colour);
  }
  /// Every pixel that is put on the canvas from now on is noted in `writes`, which must outlive the canvas.
  void note_writes(std::vector<CanvasWrite>& writes) { writes_ = &writes; }

  /// The colour so far; black outside of its part.
  Vec3d get_pixel(double x, double y) const {
    const Vec2i place = place_of(x, y);
    return colours_.contains(place.x, place.y) ? colours_.at(place.x, place.y) : Vec3d(0);
  }

  /// The depth buffer: whether 1/z is larger than all that came before at this position, which it then remembers.
  bool nearer(double x, double y, double inverse_z) {
    const Vec2i place = place_of(x, y);
    if (!nearest_.contains(place.x, place.y)) return false;
    double& nearest = nearest_.at(place.x, place.y);
    if (!(inverse_z > nearest)) return false;
    nearest = inverse_z;
    return true;
  }

  /// Whether a point lies so far from the canvas that stepping towards it would take much longer than the picture.
  /// Clipping (CGFS ch. 11) cuts at the edges of the view; listings without it leave such things out.
  bool far_outside(const Vec2d& p) const {
    if (progress_) progress_->check();
    return !(std::abs(p.x) < reach_ && std::abs(p.y) < reach_);
  }

  /// The colour at an array position inside the part.
  const Vec3d& at(int column, int row) const { return colours_.at(column - part_.x0, row - part_.y0); }
  const TileRect& part() const { return part_; }

  /// The place in the part of a position, which may lie outside of it.
  Vec2i place_of(double x, double y) const {
    if (!(std::abs(x) < reach_ && std::abs(y) < reach_)) return {-1, -1};
    return {static_cast<int>(x) + width_ / 2 - part_.x0, height_ - height_ / 2 - 1 - static_cast<int>(y) - part_.y0};
  }

 private:
  void note(const Vec2i& place, const Vec3d& colour);  // elsewhere, so that put_pixel is short

  int width_, height_;
  double reach_;  // pixels from the centre
  TileRect part_;
  Image<Vec3d> colours_;
  Image<double> nearest_;
  const Progress* progress_;
  std::vector<CanvasWrite>* writes_ = nullptr;
};

}  // namespace ps
