#include "gui/panels/space/space_style.h"

#include <algorithm>
#include <cmath>

#include "gui/theme/theme.h"

namespace ps::gui {
namespace {

const ImVec4 orange{230 / 255.f, 159 / 255.f, 0, 1}, sky_blue{86 / 255.f, 180 / 255.f, 233 / 255.f, 1};

/// A tenth of the colour is drawn about half as wide as all of it.
float ray_width(double contribution) {
  return static_cast<float>(1.2 + 2.8 * std::sqrt(std::clamp(contribution, 0.0, 1.0)));
}

}  // namespace

SpaceGroup group_of(SpaceKind kind) {
  switch (kind) {
  case SpaceKind::frustum:
  case SpaceKind::image_plane:
  case SpaceKind::pixel_cell:
    return SpaceGroup::camera;
  case SpaceKind::pixel_grid:
    return SpaceGroup::grid;
  case SpaceKind::clip_plane:
    return SpaceGroup::near_plane;
  case SpaceKind::light:
    return SpaceGroup::lights;
  case SpaceKind::eye_ray:
  case SpaceKind::sight_line:
  case SpaceKind::reflection_ray:
    return SpaceGroup::rays;
  case SpaceKind::shadow_ray_lit:
  case SpaceKind::shadow_ray_blocked:
  case SpaceKind::light_direction:
    return SpaceGroup::shadows;
  case SpaceKind::shading_normal:
  case SpaceKind::geometric_normal:
    return SpaceGroup::normals;
  case SpaceKind::hit_point:
  case SpaceKind::triangle:
  case SpaceKind::barycentric_area:
  case SpaceKind::triangle_on_image:
    return SpaceGroup::surfaces;
  case SpaceKind::rejected_triangle:
    return SpaceGroup::rejected;
  case SpaceKind::node:
    return SpaceGroup::nodes;
  case SpaceKind::silhouette:
  case SpaceKind::shadow_volume:
  case SpaceKind::shadow_map:
    return SpaceGroup::shadow_methods;
  }
  return SpaceGroup::camera;
}

SpaceStroke stroke_of(const SpaceItem& item) {
  const Palette& p = palette();
  switch (item.kind) {
  case SpaceKind::frustum:
    return {p.text_quiet, 1};
  case SpaceKind::image_plane:
    return {p.text, 1.5f};
  case SpaceKind::pixel_grid:
    return {p.text_quiet, 1};
  case SpaceKind::pixel_cell:
    return {p.attention, 1};
  case SpaceKind::clip_plane:
    return {p.text_quiet, 1, true};
  case SpaceKind::light:
    return {orange, 2};
  case SpaceKind::eye_ray:
    return {p.text, ray_width(item.contribution)};
  case SpaceKind::sight_line:
    return {p.text, 2, true};
  case SpaceKind::reflection_ray:
    return {sky_blue, ray_width(item.contribution)};
  case SpaceKind::shadow_ray_lit:
    return {orange, 1.8f};
  case SpaceKind::shadow_ray_blocked:
    return {p.wrong_mark, 1.8f, true};
  case SpaceKind::light_direction:
    return {orange, 1.6f, false, true};
  case SpaceKind::hit_point:
    return {p.text, 2};
  case SpaceKind::shading_normal:
    return {p.right_mark, 2.4f};
  case SpaceKind::geometric_normal:
    return {p.right_mark, 1.4f, true};
  case SpaceKind::triangle:
    return {p.text, item.emphasised ? 1.8f : 1.f};
  case SpaceKind::barycentric_area: {
    const ImVec4 tints[] = {sky_blue, orange, p.right_mark};
    return {tints[item.level % 3], 1};
  }
  case SpaceKind::triangle_on_image:
    return {item.emphasised ? p.text : p.text_quiet, 1};
  case SpaceKind::rejected_triangle:
    return {p.wrong_mark, 1, true};
  case SpaceKind::node:
    return {p.text_quiet, item.emphasised ? 1.4f : 1.f, !item.emphasised};
  case SpaceKind::silhouette:
    return {p.wrong_mark, 2.4f};
  case SpaceKind::shadow_volume:
    return {p.wrong_mark, 1};
  case SpaceKind::shadow_map:
    return {orange, 1.6f, true};
  }
  return {p.text, 1};
}

}  // namespace ps::gui
