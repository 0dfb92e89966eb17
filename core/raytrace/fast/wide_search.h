#pragma once
#include <span>

#include "accel/wide_bvh.h"
#include "options/settings.h"
#include "raytrace/base/placed_instance.h"
#include "raytrace/base/ray.h"

namespace ps {

/// The fast path for triangles: single rays through a tree eight wide, or past all triangles, eight triangles at a
/// time. Only boxes are tested differently from the clear path; a triangle's t and weights come from the same
/// operations in the same order, and the lowest primitive wins ties, so both find the same hit to the last bit.

/// Which triangles count besides: those that have a back let rays pass from there.
class TriangleFilter {
 public:
  virtual ~TriangleFilter() = default;
  /// May a triangle that the ray meets be a hit?
  virtual bool counts(const Vec3f& direction, std::uint32_t primitive, const TracedTriangle<float>& triangle) const = 0;
};

struct WideQuery {
  const Ray<float>& ray;
  float pad = 0;               ///< boxes are grown by this much, and a quarter more for rounding in their own test
  float triangle_epsilon = 0;  ///< for Moeller-Trumbore
  const TriangleFilter* filter = nullptr;  ///< null: every triangle counts
};

/// Work done by queries in wide trees. The same on every SIMD target, and for rays together as for each alone.
struct WideCount {
  std::uint64_t nodes = 0;
  std::uint64_t triangles = 0;
};

/// Improves `best`, whose t is at most ray.t_max, by the nearest triangle, or by any.
using WideSearch = void (*)(const WideBvh& bvh, const WideQuery& query, Hit<float>& best, WideCount& count);

/// The same by testing every triangle.
using ListSearch = void (*)(const TriangleList& list, const WideQuery& query, Hit<float>& best, WideCount& count);

/// `best[i]` for `queries[i]`, at most most_list_queries of them: each triangle is fetched once for all.
inline constexpr std::size_t most_list_queries = 8;
using ManyListSearch = void (*)(const TriangleList& list, std::span<const WideQuery> queries,
                                std::span<Hit<float>> best, WideCount& count);

struct WideSearches {
  WideSearch nearest = nullptr, any = nullptr;
  ListSearch list_nearest = nullptr, list_any = nullptr;
  ManyListSearch list_nearest_of_many = nullptr;
};

/// The functions for this test on this processor, or none (simd = off, or a processor that is not covered).
WideSearches wide_searches(Simd simd, SimdTriangleTest test);

}  // namespace ps
