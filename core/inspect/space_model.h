#pragma once
#include <string>
#include <vector>

#include "frame/view.h"
#include "record/story.h"
#include "scene/scene.h"

namespace ps {

/// What a drawable item of the space view represents.
enum class SpaceKind {
  frustum,             ///< from the eye to the image's corners
  image_plane,         ///< the picture's outline on the projection plane
  pixel_grid,          ///< a line between columns or rows of pixels (thinned)
  pixel_cell,          ///< the picked pixel on the projection plane
  clip_plane,          ///< a clipping plane's part inside the frustum
  light,               ///< where a point light is, or where a directional one comes from
  eye_ray,             ///< from the eye to what was hit
  sight_line,          ///< the same line for fragments: nothing travels along it
  reflection_ray,      ///< from a hit to the next
  shadow_ray_lit,      ///< reached its light
  shadow_ray_blocked,  ///< ended on something
  light_direction,     ///< towards a light that was not tested for shadows
  hit_point,
  shading_normal,     ///< as the renderer used it, so that a wrong one shows
  geometric_normal,   ///< only where it differs from the shading normal
  triangle,           ///< the hit triangle, or a fragment's
  barycentric_area,   ///< the part of a triangle opposite to a vertex
  triangle_on_image,  ///< a fragment's triangle on the projection plane
  rejected_triangle,  ///< never became a fragment
  node,               ///< box or sphere of the accelerator that a ray was tested against
  silhouette,         ///< an edge of the outline that an object shows to a light
  shadow_volume,      ///< a side of a shadow volume
  shadow_map          ///< what a light's shadow map covers
};

enum class SpaceShape {
  line,     ///< two or more points in a row
  arrow,    ///< two points
  outline,  ///< a closed polygon
  area,     ///< a filled polygon
  point,    ///< one point
  box       ///< the lowest and the highest corner
};

/// One thing to draw, in world space.
struct SpaceItem {
  SpaceKind kind = SpaceKind::frustum;
  SpaceShape shape = SpaceShape::line;
  std::vector<Vec3d> points;
  int event = -1;           ///< index of the event it shows; -1 = part of the set-up
  double contribution = 1;  ///< share of the pixel's colour that comes through the ray it belongs to, 0..1
  double weight = 0;        ///< barycentric areas: the vertex's weight
  int level = 0;            ///< nodes: depth in the tree; rays: number of bounces before
  bool emphasised = true;   ///< false: did not win (fragment behind, node passed by)
  std::string label = {};   ///< a few words; may be empty
};

struct SpaceBall {
  Vec3d centre{0, 0, 0};
  double radius = 0;
};

/// What is worth seeing: eye, image, lights and objects, without the ground.
struct SpaceBounds {
  Vec3d centre{0, 0, 0};
  double radius = 1;  ///< of a ball around all of it
  std::vector<SpaceBall> parts;
};

/// One pixel's story as things in space.
struct SpaceModel {
  std::vector<SpaceItem> items;
  std::vector<int> steps;  ///< events that have items, in the order in which they happened, for playing them
  SpaceBounds bounds;
  int deepest_level = 0;     ///< of the nodes
  std::vector<bool> ground;  ///< for each object, whether it is the ground
};

/// The scene's camera, image and lights, and the story's events where there is one. `view` and `settings` are those of
/// the story.
SpaceModel build_space(const Scene& scene, const View& view, const Settings& settings, const PixelStory* story);

/// The event whose items show event `selected`: itself if it has items, else the ray, hit or fragment that
/// it is about (a light's shadow ray, the hit that was shaded); -1 if there is none.
int shown_event(const SpaceModel& model, const PixelStory& story, int selected);

/// Number of items of a kind.
int count_of(const SpaceModel& model, SpaceKind kind);

}  // namespace ps
