#pragma once
#include <algorithm>
#include <cmath>

#include "raytrace/clear/intersector.h"
#include "raytrace/fast/wide_inputs.h"

namespace ps {

/// The fast paths' search: triangles with SIMD, four or eight at a time, for one ray or for eight rays of neighbouring
/// pixels; everything else by the clear path's tests. It finds the hits of the clear path (clear/intersector.h), to the
/// last bit.
class FastIntersector final : public RaySearch<float> {
 public:
  FastIntersector(const TraceInputs<float>& inputs, const WideInputs& wide, CountingRecorder& recorder)
      : inputs_(inputs), wide_(wide), geometry_(*inputs.geometry), recorder_(recorder), clear_(inputs, recorder) {}

  Hit<float> nearest(const Ray<float>& ray) const override;
  Hit<float> any(const Ray<float>& ray) const override;
  void nearest_of_each(std::span<const Ray<float>> rays, std::span<Hit<float>> hits) const override;

 private:
  using Query = Intersector<float, CountingRecorder>::Query;
  enum class Find { nearest, any };

  /// Intersector::reach() of what the wide trees hold.
  float reach_of(const Ray<float>& ray) const { return std::max(geometry_.float_reach, largest_component(ray.origin)); }
  /// The nearest hit of a ray that suits(), whose reach_of() this is. One function for each of the two, and one
  /// variable that it returns: what is done for each ray counts.
  template <Find what>
  Hit<float> find(const Ray<float>& ray, float reach) const;
  /// The nearest primitive, or any, that is not a triangle.
  Hit<float> find_other(const Ray<float>& ray, Find find) const;
  /// Improves `best` by triangles. In the class, as suits_tree() is: shadow rays need both one at a time.
  void search_tree(const Ray<float>& ray, float reach, Find find, Hit<float>& best) const {
    const WideSearch search = find == Find::any ? wide_.searches.any : wide_.searches.nearest;
    WideCount work;
    search(wide_.wide->triangles, {ray, inputs_.box_padding * reach, inputs_.triangle_epsilon}, best, work);
    count(work);
  }
  void search_list(const Ray<float>& ray, Find find, Hit<float>& best) const;

  // Up to packet_width rays at once.
  /// The last ray fills lanes that are left over. False if the rays must be searched one by one.
  bool put_side_by_side(std::span<const Ray<float>> rays, WidePacket& packet) const;
  void search_tree_together(std::span<const Ray<float>> rays, const WidePacket& packet,
                            std::span<Hit<float>> hits) const;
  void search_list_together(std::span<const Ray<float>> rays, std::span<Hit<float>> hits) const;
  /// For each ray of a packet the nearest primitive that is not a triangle.
  void nearest_others(std::span<const Ray<float>> rays, const WidePacket& packet, std::span<Hit<float>> hits) const;

  /// The arithmetic of the wide tree's boxes must not overflow: no direction that is tiny beside the ray's reach.
  static bool suits_tree(const Ray<float>& ray, float reach) {
    const Vec3f& d = ray.direction;
    return is_searchable(ray) && reach < 1e15f * std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  bool suits(const Ray<float>& ray, float reach) const {
    return wide_.wide ? suits_tree(ray, reach) : is_searchable(ray);
  }
  void count(const WideCount& work) const {
    recorder_.count(Counter::node_visits, work.nodes);
    recorder_.count(Counter::triangle_tests, work.triangles);
  }

  const TraceInputs<float>& inputs_;
  const WideInputs& wide_;
  const TracedGeometry<float>& geometry_;
  CountingRecorder& recorder_;
  Intersector<float, CountingRecorder> clear_;
};

}  // namespace ps
