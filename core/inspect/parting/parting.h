#pragma once
#include <string>
#include <string_view>

#include "record/story.h"
#include "scene/scene.h"

namespace ps {

/// Why two stories of one pixel part. Each names the step at which the renderers first did something different.
enum class PartingCause {
  none,              ///< they end in the same colour
  eye_ray,           ///< they look along different rays: sample position, projection, viewport
  epsilon,           ///< a ray meets the surface that it starts from, or jumps over what is near
  other_root,        ///< the same surface, but its other intersection
  missing_bounce,    ///< one follows a mirrored or refracted ray that the other leaves out
  missing_shadow,    ///< one asks whether a light is blocked, the other does not
  precision,         ///< the same steps in other arithmetic
  culling,           ///< a back face is dropped in one
  clipping,          ///< a triangle is clipped away in one
  fill_rule,         ///< an edge runs through the sample, and the rules give it to different triangles
  coverage,          ///< the edges lie differently: snapping of vertices, other edge arithmetic
  depth_tie,         ///< both depths are equal, or too near for the stored depth
  visibility,        ///< who covers whom is decided differently
  tessellation,      ///< a curved surface and its triangles
  silhouette,        ///< an outline passes between what a ray hits and what triangles cover
  level,             ///< another mip level
  filter,            ///< other texels or weights on the same level
  interpolation,     ///< attributes are carried across the triangle differently
  shading_position,  ///< lighting is evaluated at other points, or with other normals
  light_model,       ///< another equation of light, or a part of it left out
  texture,           ///< one reads a texture that the other leaves out
  display,           ///< the same light, shown differently
  planted_bug,       ///< a listing runs with a wrong line, which students are to find
  unexplained
};

/// One side of a comparison. Both referred to must outlive it.
struct StorySide {
  const PixelStory& story;
  const Settings& settings;
};

/// Where two stories part.
struct Parting {
  PartingCause cause = PartingCause::none;
  std::string sentence;  ///< for people; speaks of A and B; never empty
  int event_a = -1;      ///< the event of each story that shows it; -1 where one has none
  int event_b = -1;
};

/// Finds the first step at which the two stories differ, in the order in which a picture is made (the surface, its
/// place, its texture, its light, its reflection), and names the cause from the events and from the options that
/// differ. Both stories are of the same scene and pixel. What no rule explains is called unexplained. Where a listing
/// runs with a planted bug no cause is named but that: events and options show what followed from the wrong line, and
/// not which one it is.
Parting find_parting(const Scene& scene, const StorySide& a, const StorySide& b);

}  // namespace ps
