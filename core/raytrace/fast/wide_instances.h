#pragma once
#include <memory>
#include <vector>

#include "accel/wide_bvh.h"
#include "raytrace/base/two_level.h"
#include "raytrace/fast/wide_geometry.h"
#include "raytrace/fast/wide_search.h"

namespace ps {

/// Vertices of a model's triangles side by side, in the model's space. Places without a triangle hold NaN.
struct alignas(64) ModelBlock {
  double corner[3][3][block_width];  ///< [corner a b c][axis][lane]
  std::uint32_t triangle[block_width];
};

/// A model's tree eight wide, kept once for all its instances.
struct WideModel {
  LargeArray<WideNode> nodes;
  LargeArray<ModelBlock> blocks;

  std::size_t heap_bytes() const { return owned_bytes(nodes, blocks); }
};

struct WideInstance {
  std::uint32_t model = 0;             ///< index into WideInstances::models
  std::uint32_t first = 0, count = 0;  ///< the numbers of its triangles
  bool in_double = false;              ///< some of them are tested in double
  IntoModel into;
  Transform transform;
};

/// TwoLevel as SIMD searches it: both levels are trees eight wide.
struct WideInstances {
  LargeArray<WideNode> top;  ///< each leaf is an instance: its index, plus 1, since wide_empty_block is none
  SeenFrom<float> seen;      ///< how `top` is seen
  std::vector<WideModel> models;
  std::vector<WideInstance> instances;
  Bvh<float> others;  ///< over all that is not an instance; its order holds numbers of primitives

  std::size_t heap_bytes() const { return owned_bytes(top, models, instances, others); }
};

std::shared_ptr<const WideInstances> wide_instances(const Scene& scene, const TracedGeometry<float>& geometry,
                                                    const TwoLevel<float>& trees, Prepared& prepared);

/// The clear path's test of one triangle, for those that SIMD does not test.
class SingleTests {
 public:
  virtual ~SingleTests() = default;
  /// Makes the triangle with this number the best hit if it is. Returns whether it is.
  virtual bool test(const Ray<float>& ray, std::uint32_t number, Hit<float>& best) const = 0;
};

/// Improves `best` by the nearest triangle of an instance, or by any. Vertices are placed in the world eight triangles
/// at a time, by the operations of placed_corner(), so hits are those of the unfolded triangles to the last bit. The
/// query's filter must leave out triangles without area.
using InstanceSearch = void (*)(const WideInstances& all, const WideQuery& query, const SingleTests& single,
                                Hit<float>& best, WideCount& count);

struct InstanceSearches {
  InstanceSearch nearest = nullptr, any = nullptr;
};

/// The functions for this test on this processor, or none.
InstanceSearches instance_searches(Simd simd, SimdTriangleTest test);

}  // namespace ps
