#pragma once
#include <optional>
#include <string>

#include "inspect/space_picture.h"
#include "inspect/space_projection.h"
#include "inspect/space_style.h"

namespace ps {

/// Calls `take(item)` for the items that are shown, in the order in which they are drawn: faint ones first.
template <class Take>
void for_each_shown(const SpaceModel& model, const SpaceLook& look, const Take& take) {
  constexpr int last_layer = 4;
  const auto layer = [&](const SpaceItem& item) {
    if (item.event >= 0 && item.event == look.highlighted) return last_layer;
    switch (item.shape) {
    case SpaceShape::box:
      return 0;
    case SpaceShape::area:
      return item.kind == SpaceKind::pixel_cell ? 2 : 1;
    case SpaceShape::line:
    case SpaceShape::arrow:
    case SpaceShape::outline:
      return item.event < 0 ? 0 : 2;
    case SpaceShape::point:
      return 3;
    }
    return 2;
  };
  for (int wanted = 0; wanted <= last_layer; ++wanted)
    for (const SpaceItem& item : model.items)
      if (layer(item) == wanted && is_shown(item, look)) take(item);
}

/// Calls `take(from, to)` for each straight line that an item consists of; an area or a point has none.
template <class Take>
void for_each_line(const SpaceItem& item, const Take& take) {
  const auto& points = item.points;
  switch (item.shape) {
  case SpaceShape::line:
  case SpaceShape::arrow:
    for (std::size_t i = 1; i < points.size(); ++i) take(points[i - 1], points[i]);
    return;
  case SpaceShape::outline:
    for (std::size_t i = 0; i < points.size(); ++i) take(points[i], points[(i + 1) % points.size()]);
    return;
  case SpaceShape::box: {
    const auto corner = [&](int k) { return Vec3d(points[k & 1].x, points[k >> 1 & 1].y, points[k >> 2 & 1].z); };
    for (int k = 0; k < 8; ++k)
      for (const int bit : {1, 2, 4})
        if ((k & bit) == 0) take(corner(k), corner(k | bit));
    return;
  }
  case SpaceShape::area:
  case SpaceShape::point:
    return;
  }
}

/// What was drawn.
struct SpaceDrawn {
  int items = 0, rays = 0, shadow_rays = 0, boxes = 0;
  std::optional<Vec2d> highlight_place;  ///< somewhere on what is highlighted
};

/// Draws the model over the picture that `projection` and `depth` belong to, whose top left corner is that of `area`.
/// Parts behind surfaces are thin and dashed.
SpaceDrawn draw_space(Painter& painter, const PaintArea& area, const SpaceModel& model,
                      const SpaceProjection& projection, const Image<float>& depth, const SpaceLook& look);

/// The space view as an SVG file: the scene from outside as a pale picture, the model over it.
std::string space_svg(const SpaceModel& model, const SpacePicture& picture, const SpaceLook& look = {});

}  // namespace ps
