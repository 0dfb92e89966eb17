#pragma once
#include <array>
#include <string_view>

#include "document/story_view.h"
#include "inspect/space_style.h"

namespace ps::gui {

/// A group in the list that shows and hides them.
struct SpaceGroupRow {
  SpaceGroup group;
  std::string_view key, label, help;
  SpaceKind like;  ///< whose colour represents it in the legend
};
inline constexpr std::array space_groups{
    SpaceGroupRow{SpaceGroup::camera, "camera", "Camera and image", "The eye, and the picture where it is projected.",
                  SpaceKind::image_plane},
    SpaceGroupRow{SpaceGroup::grid, "grid", "Pixel grid", "A grid line every n rows and columns of the picture.",
                  SpaceKind::pixel_grid},
    SpaceGroupRow{SpaceGroup::rays, "rays", "Eye and reflected rays",
                  "The wider a ray, the more it contributes to the colour.", SpaceKind::reflection_ray},
    SpaceGroupRow{SpaceGroup::shadows, "shadows", "Shadow rays",
                  "Solid: the light reaches the point. Dashed with a cross: blocked. Dotted: not tested.",
                  SpaceKind::shadow_ray_lit},
    SpaceGroupRow{SpaceGroup::normals, "normals", "Normals", "The normals that shading used.",
                  SpaceKind::shading_normal},
    SpaceGroupRow{SpaceGroup::surfaces, "surfaces", "Triangles and weights",
                  "The triangle, divided into three areas: the weights of its vertices.", SpaceKind::barycentric_area},
    SpaceGroupRow{SpaceGroup::lights, "lights", "Lights",
                  "Positions of point lights, directions of directional lights.", SpaceKind::light},
    SpaceGroupRow{SpaceGroup::rejected, "rejected", "Rejected triangles",
                  "Triangles that produced no fragment at this pixel.", SpaceKind::rejected_triangle},
    SpaceGroupRow{SpaceGroup::nodes, "nodes", "Accelerator boxes", "Bounding boxes that a ray was tested against.",
                  SpaceKind::node},
    SpaceGroupRow{SpaceGroup::near_plane, "clip-planes", "Clipping planes",
                  "The planes that bound what is drawn: the near plane and, for the rasterizer, the side planes and "
                  "the far plane.",
                  SpaceKind::clip_plane},
    SpaceGroupRow{
        SpaceGroup::shadow_methods, "shadow-methods", "Shadow volumes and maps",
        "Silhouette edges with the side faces of their shadow volumes, or the region that each shadow map covers.",
        SpaceKind::shadow_volume}};
static_assert(space_groups.size() == space_group_count);

/// Which of space_groups are drawn.
SpaceGroups shown_groups(const OutsideView& outside);
/// Shows a group that is hidden, and hides one that is shown.
void switch_group(OutsideView& outside, SpaceGroup group);

}  // namespace ps::gui
