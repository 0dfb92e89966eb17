#pragma once
#include <vector>

#include "frame/view.h"
#include "options/settings.h"
#include "scene/canvas_item.h"

namespace ps {

/// What to render so as to see a small part of a picture enlarged.
struct EnlargedView {
  View view;
  Settings settings;  ///< one sample for each pixel, at its centre
};

/// A square part of the picture of `view` and `settings`, drawn with `pixels` pixels a side. `low` is its top left
/// corner and `side` its size, in pixels of that picture from its top left corner; it may reach beyond the picture. The
/// eye stays where it is and looks through a smaller piece of the same projection plane, so that both renderers draw
/// what lies inside a pixel with the rays, or the projection, that they always use.
EnlargedView enlarge(const View& view, const Settings& settings, const Vec2d& low, double side, int pixels);

/// Filled triangles of the canvas as they lie on that picture, without their outlines. Lines are left out: they are
/// walked pixel by pixel, so there is nothing between the pixels.
std::vector<CanvasItem> enlarged_canvas(const std::vector<CanvasItem>& items, const View& view, const Vec2d& low,
                                        double side, int pixels);

}  // namespace ps
