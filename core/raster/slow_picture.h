#pragma once
#include "frame/slow_motion.h"
#include "raster/assembly/bins.h"
#include "raster/base/raster_inputs.h"
#include "raster/setup/draw_stage.h"

namespace ps::raster {

/// A picture of the clear path up to a triangle or a fragment.
template <class Real>
class SlowPicture {
 public:
  SlowPicture(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
              Prepared& prepared, Progress& progress);

  /// Each walk over the triangles takes them all in drawing order, a triangle that was clipped with all its pieces.
  /// Then deferred shading shades its winners in one go, and after that come the shapes on the canvas.
  SlowFrame after_triangles(std::uint64_t at);
  /// The picture is drawn as one tile, and stops where the next fragment would begin. `whole` knows how many there are.
  SlowFrame after_fragments(std::uint64_t at, const Frame& whole);

 private:
  struct Progressed;
  Progressed progressed(std::uint64_t at) const;
  void draw_tile(const TileRect& tile, std::size_t index, const Progressed& done, Frame& frame, Counters& counters);
  void note_last(const Progressed& done, SlowState& state) const;
  void note_triangle(const PrimitiveRef& ref, SlowState& state) const;
  std::string_view stage_name(std::size_t step) const;

  const Scene& scene_;
  const View& view_;
  const RenderRequest& request_;
  Progress& progress_;
  ParallelOptions parallel_;
  RasterInputs<Real> inputs_;
  ScreenGeometry<Real> geometry_;
  std::vector<PrimitiveRef> order_;
  std::vector<std::size_t> ends_;  // of each whole triangle's pieces in order_
  std::vector<DrawStep> steps_;
};

}  // namespace ps::raster
