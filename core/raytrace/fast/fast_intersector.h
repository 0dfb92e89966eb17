#pragma once
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

  Hit<float> find(const Ray<float>& ray, Find find) const;
  /// The nearest primitive, or any, that is not a triangle.
  Hit<float> find_other(const Ray<float>& ray, Find find) const;
  /// Improves `best` by triangles.
  void search_tree(const Ray<float>& ray, Find find, Hit<float>& best) const;
  void search_list(const Ray<float>& ray, Find find, Hit<float>& best) const;

  // Up to packet_width rays at once.
  bool suits_together(std::span<const Ray<float>> rays) const;
  void search_tree_together(std::span<const Ray<float>> rays, std::span<Hit<float>> hits) const;
  void search_list_together(std::span<const Ray<float>> rays, std::span<Hit<float>> hits) const;
  /// For each ray of a packet the nearest primitive that is not a triangle.
  void nearest_others(std::span<const Ray<float>> rays, const WidePacket& packet, std::span<Hit<float>> hits) const;

  /// The arithmetic of the wide tree's boxes must not overflow: no direction that is tiny beside the scene, no NaN.
  bool suits_tree(const Ray<float>& ray) const;
  float padding(const Ray<float>& ray) const { return inputs_.box_padding * clear_.reach(ray); }
  void count(const WideCount& work) const;

  const TraceInputs<float>& inputs_;
  const WideInputs& wide_;
  const TracedGeometry<float>& geometry_;
  CountingRecorder& recorder_;
  Intersector<float, CountingRecorder> clear_;
};

}  // namespace ps
