#include "inspect/microscope/enlarge.h"

#include "frame/viewport.h"

namespace ps {

EnlargedView enlarge(const View& view, const Settings& settings, const Vec2d& low, double side, int pixels) {
  const Viewport<double> viewport = make_viewport<double>(view, settings);
  const Vec2d middle = viewport.at(0, 0, low + Vec2d(side / 2));
  EnlargedView enlarged{{view.camera, pixels, pixels}, settings};
  Camera& camera = enlarged.view.camera;
  camera.viewport_width = side * viewport.width / viewport.span_x;
  camera.viewport_height = side * viewport.height / viewport.span_y;
  const Vec3d aside = camera.right * middle.x + camera.up * middle.y;
  // A sheared frame keeps the projection plane, and depth along the old forward axis, where they are.
  if (viewport.projection == Projection::perspective)
    camera.forward += aside / viewport.distance;
  else
    camera.position += aside;
  Settings& how = enlarged.settings;
  how.viewport_fit = ViewportFit::stretch;
  how.field_of_view_span = FieldOfViewSpan::edges;
  how.sample_position = SamplePosition::centre;
  how.samples_per_pixel = 1;
  how.sample_pattern = SamplePattern::grid;
  how.adaptive_sampling = false;
  how.subsampling = 1;
  how.multisampling = 1;
  how.canvas_fill = CanvasFill::edges;  // rows of the larger pixels would lie elsewhere
  how.tessellation = settings.tessellation * pixels / side;
  return enlarged;
}

std::vector<CanvasItem> enlarged_canvas(const std::vector<CanvasItem>& items, const View& view, const Vec2d& low,
                                        double side, int pixels) {
  // The canvas counts from its centre, y up; pictures from their top left, y down.
  const Vec2d middle(view.width / 2, view.height - view.height / 2);
  const Vec2d new_middle(pixels / 2, pixels - pixels / 2);
  std::vector<CanvasItem> enlarged;
  for (const CanvasItem& item : lines_and_triangles(items)) {
    const auto* triangle = std::get_if<CanvasTriangle>(&item);
    if (!triangle || !triangle->filled) continue;
    CanvasTriangle large = *triangle;
    large.outline.reset();
    for (Vec2d& point : large.points) {
      const Vec2d at = (Vec2d(middle.x + point.x, middle.y - point.y) - low) * (pixels / side);
      point = {at.x - new_middle.x, new_middle.y - at.y};
    }
    enlarged.push_back(large);
  }
  return enlarged;
}

}  // namespace ps
