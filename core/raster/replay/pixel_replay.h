#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "raster/assembly/bins.h"
#include "raster/base/fragment.h"

namespace ps::raster {

/// A triangle near a pixel, with what the kernel did with it at one point of the pixel.
template <class Real>
struct ReplayedTriangle {
  TriangleSetup<Real> setup;  ///< with the edges of the point
  Fragment<Real> fragment;    ///< there, whether the triangle covers it or not
  std::optional<Real> depth;  ///< there, encoded, as a depth buffer compares it; nullopt without one
  bool covered = false;       ///< the point lies in it
  bool cut_out = false;       ///< but an opacity map cuts it out there
  bool passed = false;        ///< it hides all triangles before it
};

/// Draws the triangles near a pixel again by the kernel that draws the picture, with the sample at any point of the
/// pixel or its margin. Triangles that cover no sample of the picture are not among them.
template <class Real>
class PixelReplay {
 public:
  using IsNear = std::function<bool(const ScreenTriangle<Real>&)>;
  /// The picture must fill its primitives. `inputs` must outlive the replay.
  PixelReplay(const RasterInputs<Real>& inputs, Vec2i pixel, const ParallelOptions& parallel, Progress& progress,
              const IsNear& is_near);

  /// All of them in drawing order, with the sample at this place in the pixel: pixels from its top left corner, on the
  /// grid of vertices. Elsewhere than at the picture's own only sample, edge functions decide about coverage.
  std::vector<ReplayedTriangle<Real>> at(const Vec2d& point) const;
  /// The triangle that each of the picture's samples in the pixel shows, by its number in drawing order; -1 where a
  /// sample shows none.
  std::vector<int> shown() const;
  /// A triangle with the edges of the picture's own sample.
  TriangleSetup<Real> set_up(int number) const;

 private:
  enum class Boxes { own, pixel };  ///< of triangles: those of the picture's samples, or the whole pixel
  PrimitiveRef ref(std::size_t number, Boxes boxes) const;
  template <class Visit>
  void draw(const RasterInputs<Real>& inputs, Boxes boxes, Visit&& visit) const;

  const RasterInputs<Real>& inputs_;
  Vec2i pixel_;
  ScreenGeometry<Real> geometry_;  ///< behind the batches as assembled the same ones with Boxes::pixel
  std::uint32_t batches_ = 0;      ///< as assembled
  std::vector<PrimitiveRef> near_;
};

}  // namespace ps::raster
