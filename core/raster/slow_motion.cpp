#include "raster/slow_motion.h"

#include <algorithm>

#include "frame/pixel_order.h"
#include "frame/region.h"
#include "frame/whole_picture.h"
#include "raster/renderer.h"
#include "raster/slow_picture.h"

namespace ps {
namespace {

std::shared_ptr<const WholePicture> finished(const Scene& scene, const View& view, const Settings& settings,
                                             const RenderRequest& request, Prepared& prepared, Progress& progress) {
  return whole_picture(scene, view, settings, request, prepared,
                       [&](const Settings& which, const RenderRequest& plain) {
                         return render_rasterized(scene, view, which, plain, prepared, progress);
                       });
}

template <class Real>
SlowFrame draw(const Scene& scene, const View& view, const Settings& settings, const SlowMotion& motion,
               const RenderRequest& request, Prepared& prepared, Progress& progress) {
  raster::SlowPicture<Real> picture(scene, view, settings, request, prepared, progress);
  if (motion.unit == SlowUnit::triangles) return picture.after_triangles(motion.at);
  RenderRequest whole = request;
  whole.region.reset();  // the picture is drawn as one tile
  const auto all = finished(scene, view, settings, whole, prepared, progress);
  return picture.after_fragments(motion.at, all->frame);
}

}  // namespace

std::optional<std::string_view> rasterized_slow_motion_lacks(SlowUnit unit, const Settings& settings,
                                                             const SceneTraits& traits) {
  switch (unit) {
  case SlowUnit::triangles:
  case SlowUnit::tiles:
    return {};
  case SlowUnit::fragments:
    if (settings.draw != Draw::filled) return "needs draw = filled";
    if (traits.canvas_items && !traits.canvas_triangles && !traits.triangles && !traits.spheres)
      return "lines have no fragments: choose triangles, which counts lines as well";
    return {};
  case SlowUnit::pixels:
  case SlowUnit::rows:
    return "ray tracer only: here the loop over pixels is inside the one over triangles (choose fragments)";
  case SlowUnit::samples:
    return "ray tracer only: a fragment writes all samples that it covers at once";
  case SlowUnit::writes:
    return "listings only: fragments come nearest to them";
  }
  return {};
}

SlowFrame rasterize_slowly(const Scene& scene, const View& view, const Settings& settings, const SlowMotion& motion,
                           const RenderRequest& request, Prepared& prepared, Progress& progress) {
  require_rasterized_size(view);
  if (motion.unit == SlowUnit::tiles) {
    const TileRect region = asked_region(request, view.width, view.height);
    SlowFrame slow;
    const std::vector<TileRect> done =
        PixelOrder(view.width, view.height, clear_tile_size, region).done(motion, slow.state);
    slow.frame = part_of(finished(scene, view, settings, request, prepared, progress)->frame, done, scene.background);
    if (request.region) clear_outside(region, slow.frame);
    return slow;
  }
  switch (settings.precision) {
  case Precision::float32:
    return draw<float>(scene, view, settings, motion, request, prepared, progress);
  case Precision::float64:
    return draw<double>(scene, view, settings, motion, request, prepared, progress);
  }
  return {};
}

}  // namespace ps
