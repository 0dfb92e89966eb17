#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "frame/view.h"
#include "scene/mesh.h"

namespace ps::bench {

/// A ray as both sides get it: points origin + t * direction with 0 < t < t_max.
struct BenchRay {
  Vec3f origin, direction;
  float t_max;
};

inline constexpr std::uint32_t no_hit = 0xffffffffu;

/// The answer for one ray: the triangle and t, or no_hit. For "any hit" only found or not counts.
struct BenchHit {
  std::uint32_t triangle = no_hit;
  float t = 0;
};

/// Finds the nearest hit of each ray; spans have equal length.
using FindNearest = std::function<void(std::span<const BenchRay>, std::span<BenchHit>)>;

/// One ray through each pixel's centre, row by row.
std::vector<BenchRay> primary_rays(const View& view);

/// From the surface points that `primary` rays meet, lifted a little off the surface towards their side.
struct SurfacePoints {
  std::vector<Vec3f> points;
  std::vector<Vec3f> normals;  ///< unit, on the side that was seen
};
SurfacePoints surface_points(const Mesh& mesh, std::span<const BenchRay> primary, const FindNearest& nearest);

/// From each point to the light, in the order of the pixels; t_max = 1 is the light.
std::vector<BenchRay> shadow_rays(const SurfacePoints& surface, const Vec3d& light);

/// From each point into a random direction of its hemisphere, cosine-weighted, in random order. Always the same.
std::vector<BenchRay> random_rays(const SurfacePoints& surface);

/// Empty if both answered alike, else the first difference. A share of 1e-4 of the rays may differ (rays that pass
/// within rounding of an edge); `note` gets the counts.
std::string compare_hits(std::span<const BenchHit> ours, std::span<const BenchHit> theirs, std::string& note);

}  // namespace ps::bench
