#pragma once
#include <algorithm>
#include <cmath>

#include "raytrace/clear/intersector.h"
#include "raytrace/fast/wide_inputs.h"

namespace ps {

/// Triangles that are seen from their front alone let rays pass from behind. Where meshes are shared, triangles without
/// area are there, too.
class FrontsOnly final : public TriangleFilter {
 public:
  explicit FrontsOnly(const TracedGeometry<float>& geometry) : geometry_(geometry) {}
  bool counts(const Vec3f& direction, std::uint32_t number, const TracedTriangle<float>& triangle) const override {
    if (shares_meshes(geometry_) && !has_area(triangle)) return false;
    const Primitive primitive = primitive_of(geometry_, number);
    return !(primitive.front_only && sees_back(direction, primitive, triangle));
  }

 private:
  const TracedGeometry<float>& geometry_;
};

/// The clear path's tests, for the SIMD search.
class ClearTests final : public SingleTests {
 public:
  using Clear = Intersector<float, CountingRecorder>;
  explicit ClearTests(const Clear& clear) : clear_(clear) {}
  bool test(const Ray<float>& ray, std::uint32_t number, Hit<float>& best) const override {
    return clear_.test({ray, dot(ray.direction, ray.direction), Shear<float>(ray.direction)}, number, best);
  }

 private:
  const Clear& clear_;
};

/// The fast paths' search: triangles with SIMD, eight at a time for one ray, or one by one for many rays of
/// neighbouring pixels; everything else by the clear path's tests. It finds the hits of the clear path
/// (clear/intersector.h), to the last bit.
class FastIntersector final : public RaySearch<float> {
 public:
  FastIntersector(const TraceInputs<float>& inputs, const WideInputs& wide, CountingRecorder& recorder)
      : inputs_(inputs), wide_(wide), geometry_(*inputs.geometry), recorder_(recorder), clear_(inputs, recorder),
        clear_tests_(clear_), fronts_only_(geometry_),
        filter_(geometry_.one_sided_triangles || shares_meshes(geometry_) ? &fronts_only_ : nullptr) {}
  FastIntersector(const FastIntersector&) = delete;
  FastIntersector& operator=(const FastIntersector&) = delete;

  Hit<float> nearest(const Ray<float>& ray) const override;
  Hit<float> any(const Ray<float>& ray) const override;
  void nearest_of_each(std::span<const Ray<float>> rays, std::span<Hit<float>> hits) const override;

 private:
  using Query = Intersector<float, CountingRecorder>::Query;
  enum class Find { nearest, any };

  /// The largest coordinate, of the wide trees' contents or of the ray's origin, as WideInputs::seen says.
  float reach_of(const Ray<float>& ray) const {
    return std::max(wide_.seen.reach, largest_component(ray.origin - wide_.seen.centre));
  }
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
    search(wide_.wide->triangles, {ray, inputs_.box_padding * reach, inputs_.triangle_epsilon, filter_}, best, work);
    count(work);
  }
  void search_instances(const Ray<float>& ray, float reach, Find find, Hit<float>& best) const;
  void search_list(const Ray<float>& ray, Find find, Hit<float>& best) const;

  // As many rays at once as go together.
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
    return wide_.list ? is_searchable(ray) : suits_tree(ray, reach);
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
  ClearTests clear_tests_;
  FrontsOnly fronts_only_;
  const TriangleFilter* filter_;  ///< null where every triangle counts
};

}  // namespace ps
