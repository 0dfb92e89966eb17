#pragma once
#include <imgui.h>

#include <array>
#include <string_view>

#include "inspect/space_model.h"

namespace ps::gui {

/// What can be shown and hidden together in the space view.
enum class SpaceGroup {
  camera,
  grid,
  rays,
  shadows,
  normals,
  surfaces,
  lights,
  rejected,
  nodes,
  near_plane,
  shadow_methods
};

struct SpaceGroupRow {
  SpaceGroup group;
  std::string_view key, label, help;
  bool shown;      ///< at first
  SpaceKind like;  ///< whose colour represents it in the legend
};
inline constexpr std::array space_groups{
    SpaceGroupRow{SpaceGroup::camera, "camera", "Camera and image", "The eye, and the picture where it is projected.",
                  true, SpaceKind::image_plane},
    SpaceGroupRow{SpaceGroup::grid, "grid", "Pixel grid", "A grid line every n rows and columns of the picture.", true,
                  SpaceKind::pixel_grid},
    SpaceGroupRow{SpaceGroup::rays, "rays", "Eye and reflected rays",
                  "The wider a ray, the more it contributes to the colour.", true, SpaceKind::reflection_ray},
    SpaceGroupRow{SpaceGroup::shadows, "shadows", "Shadow rays",
                  "Solid: the light reaches the point. Dashed with a cross: blocked. Dotted: not tested.", true,
                  SpaceKind::shadow_ray_lit},
    SpaceGroupRow{SpaceGroup::normals, "normals", "Normals", "The normals that shading used.", true,
                  SpaceKind::shading_normal},
    SpaceGroupRow{SpaceGroup::surfaces, "surfaces", "Triangles and weights",
                  "The triangle, divided into three areas: the weights of its vertices.", true,
                  SpaceKind::barycentric_area},
    SpaceGroupRow{SpaceGroup::lights, "lights", "Lights",
                  "Positions of point lights, directions of directional lights.", true, SpaceKind::light},
    SpaceGroupRow{SpaceGroup::rejected, "rejected", "Rejected triangles",
                  "Triangles that produced no fragment at this pixel.", false, SpaceKind::rejected_triangle},
    SpaceGroupRow{SpaceGroup::nodes, "nodes", "Accelerator boxes", "Bounding boxes that a ray was tested against.",
                  false, SpaceKind::node},
    SpaceGroupRow{SpaceGroup::near_plane, "clip-planes", "Clipping planes",
                  "The planes that bound what is drawn: the near plane and, for the rasterizer, the side planes and "
                  "the far plane.",
                  false, SpaceKind::clip_plane},
    SpaceGroupRow{
        SpaceGroup::shadow_methods, "shadow-methods", "Shadow volumes and maps",
        "Silhouette edges with the side faces of their shadow volumes, or the region that each shadow map covers.",
        true, SpaceKind::shadow_volume}};

SpaceGroup group_of(SpaceKind kind);

/// How a kind is drawn. Colours are of the Okabe-Ito palette and never the only sign.
struct SpaceStroke {
  ImVec4 colour;
  float width = 1;      ///< pixels at scale 1
  bool dashed = false;  ///< with long dashes
  bool dotted = false;
};
SpaceStroke stroke_of(const SpaceItem& item);

}  // namespace ps::gui
