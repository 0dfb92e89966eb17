#pragma once
#include <algorithm>

#include "frame/view.h"
#include "math/conventions.h"
#include "options/settings.h"

namespace ps {

/// The rectangle of the projection plane that the picture shows, and how pixels lie on it (math/conventions.h). Shared
/// by both renderers: rays go through `at(...)`, fragments are projected with the same numbers.
///
/// Viewport position v and centred canvas position p (pixels, y up): v.x = p.x * width / span_x, likewise y.
template <class Real>
struct Viewport {
  int columns = 0, rows = 0;    ///< picture size, pixels
  Real width = 1, height = 1;   ///< world units, after viewport-fit
  Real span_x = 1, span_y = 1;  ///< how many pixels the width and the height span
  Real distance = 1;            ///< projection_plane_d, world units
  Vec2d sample{0.5, 0.5};       ///< of the one sample, from a pixel's top-left corner
  Projection projection = Projection::perspective;

  /// Viewport position of the sample of pixel (column, row): coordinates along the camera's right and up.
  Vec2<Real> at(int column, int row) const { return at(column, row, sample); }
  /// The same for a sample anywhere in the pixel, `offset` from its top-left corner.
  Vec2<Real> at(int column, int row, const Vec2d& offset) const {
    const Vec2<Real> p = canvas_position<Real>(column, row, offset, columns, rows);
    return {p.x * width / span_x, p.y * height / span_y};
  }
};

/// The size is that of the camera's viewport, with one side changed as `viewport_fit` asks to give it the shape of the
/// picture. `field_of_view_span` decides whether it reaches from edge to edge or from first to last sample.
template <class Real>
Viewport<Real> make_viewport(const View& view, const Settings& settings) {
  double width = view.camera.viewport_width;
  double height = view.camera.viewport_height;
  switch (settings.viewport_fit) {
  case ViewportFit::height:
    width = height * view.width / view.height;
    break;
  case ViewportFit::width:
    height = width * view.height / view.width;
    break;
  case ViewportFit::stretch:
    break;
  }
  const int less = settings.field_of_view_span == FieldOfViewSpan::centres ? 1 : 0;
  Viewport<Real> viewport;
  viewport.columns = view.width;
  viewport.rows = view.height;
  viewport.width = static_cast<Real>(width);
  viewport.height = static_cast<Real>(height);
  viewport.span_x = static_cast<Real>(std::max(view.width - less, 1));
  viewport.span_y = static_cast<Real>(std::max(view.height - less, 1));
  viewport.distance = static_cast<Real>(view.camera.projection_plane_d);
  viewport.sample = settings.sample_position == SamplePosition::corner ? sample_at_book_corner : sample_at_centre;
  viewport.projection = settings.projection;
  return viewport;
}

}  // namespace ps
