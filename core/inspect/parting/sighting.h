#pragma once
#include <optional>
#include <vector>

#include "record/story.h"

namespace ps {

/// The visible surface of one ray or one pixel of the rasterizer, and its shading. Members are indices into the story's
/// events, -1 where there is no such event.
struct Sighting {
  int ray = -1;                   ///< the RayEvent; -1 for fragments
  int seen = -1;                  ///< the HitEvent, the MissEvent, or the FragmentEvent that was written last
  PixelId id;                     ///< the visible surface; no object for the background
  std::vector<int> lights;        ///< LightEvents, in order
  std::vector<int> textures;      ///< TextureEvents, in order
  int shade = -1;                 ///< ShadeEvent; -1 where there is one for each light
  std::vector<int> mirrored_ray;  ///< RayEvents of the reflection, at most one
  std::vector<int> refracted_ray;
};

/// The visible surface of the ray with event index `ray`.
Sighting sight_of_ray(const PixelStory& story, int ray);
/// The visible surface of the pixel of a rasterized picture.
Sighting sight_of_fragments(const PixelStory& story);
/// The shadow rays that start at the surface that ray `ray` saw, in the order of the lights that sent for one.
std::vector<int> shadow_rays_of(const PixelStory& story, int ray);

/// Camera-space depth or ray parameter of the visible surface.
std::optional<double> seen_depth(const PixelStory& story, const Sighting& sighting);

}  // namespace ps
