#include "inspect/space_style.h"

#include <algorithm>
#include <cmath>

namespace ps {
namespace {

/// A tenth of the colour is drawn about half as wide as all of it.
double ray_width(double contribution) { return 1.2 + 2.8 * std::sqrt(std::clamp(contribution, 0.0, 1.0)); }

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

SpaceGroups first_space_groups() {
  SpaceGroups groups;
  groups.fill(true);
  for (const SpaceGroup hidden : {SpaceGroup::rejected, SpaceGroup::nodes, SpaceGroup::near_plane})
    groups[static_cast<std::size_t>(hidden)] = false;
  return groups;
}

bool is_shown(const SpaceItem& item, const SpaceLook& look) {
  const SpaceGroup group = group_of(item.kind);
  if (!look.groups[static_cast<std::size_t>(group)]) return false;
  if (look.up_to_event >= 0 && item.event > look.up_to_event) return false;
  if (group == SpaceGroup::nodes) return item.level <= look.deepest_level;
  return item.contribution >= look.least_contribution || group == SpaceGroup::rejected;
}

Stroke stroke_of(const SpaceItem& item) {
  switch (item.kind) {
  case SpaceKind::frustum:
    return {{Role::quiet}, 1};
  case SpaceKind::image_plane:
    return {{Role::ink}, 1.5};
  case SpaceKind::pixel_grid:
    return {{Role::quiet}, 1};
  case SpaceKind::pixel_cell:
    return {{Role::attention}, 1};
  case SpaceKind::clip_plane:
    return {{Role::quiet}, 1, dashed};
  case SpaceKind::light:
    return {{Role::light}, 2};
  case SpaceKind::eye_ray:
    return {{Role::ink}, ray_width(item.contribution)};
  case SpaceKind::sight_line:
    return {{Role::ink}, 2, dashed};
  case SpaceKind::reflection_ray:
    return {{Role::mirror}, ray_width(item.contribution)};
  case SpaceKind::shadow_ray_lit:
    return {{Role::light}, 1.8};
  case SpaceKind::shadow_ray_blocked:
    return {{Role::wrong}, 1.8, dashed};
  case SpaceKind::light_direction:
    return {{Role::light}, 1.6, dotted};
  case SpaceKind::hit_point:
    return {{Role::ink}, 2};
  case SpaceKind::shading_normal:
    return {{Role::right}, 2.4};
  case SpaceKind::geometric_normal:
    return {{Role::right}, 1.4, dashed};
  case SpaceKind::triangle:
    return {{Role::ink}, item.emphasised ? 1.8 : 1.0};
  case SpaceKind::barycentric_area: {
    constexpr Role roles[] = {Role::mirror, Role::light, Role::right};
    return {{roles[item.level % 3]}, 1};
  }
  case SpaceKind::triangle_on_image:
    return {{item.emphasised ? Role::ink : Role::quiet}, 1};
  case SpaceKind::rejected_triangle:
    return {{Role::wrong}, 1, dashed};
  case SpaceKind::node:
    return {{Role::quiet}, item.emphasised ? 1.4 : 1.0, item.emphasised ? unbroken : dashed};
  case SpaceKind::silhouette:
    return {{Role::wrong}, 2.4};
  case SpaceKind::shadow_volume:
    return {{Role::wrong}, 1};
  case SpaceKind::shadow_map:
    return {{Role::light}, 1.6, dashed};
  }
  return {{Role::ink}, 1};
}

}  // namespace ps
