#pragma once
#include <algorithm>
#include <cmath>
#include <span>

#include "raytrace/base/ray_search.h"
#include "raytrace/base/trace_inputs.h"
#include "raytrace/clear/csg.h"
#include "raytrace/clear/sphere_robust.h"
#include "raytrace/clear/triangle_watertight.h"
#include "record/recorder.h"

namespace ps {

/// The clear path's search: the accelerator names the primitives that a ray may meet, and each is tested by itself
/// (CGFS ch. 2 and 5). Its parts also test what faster searches leave over.
template <class Real, class Recorder>
class Intersector final : public RaySearch<Real> {
 public:
  Intersector(const TraceInputs<Real>& inputs, Recorder& recorder)
      : inputs_(inputs), geometry_(*inputs.geometry), recorder_(recorder) {}

  Hit<Real> nearest(const Ray<Real>& ray) const override;
  Hit<Real> any(const Ray<Real>& ray) const override;
  void nearest_of_each(std::span<const Ray<Real>> rays, std::span<Hit<Real>> hits) const override;
  /// Whether the ray meets this primitive; found() or not.
  Hit<Real> one(const Ray<Real>& ray, std::uint32_t primitive) const { return among(ray, std::span(&primitive, 1)); }
  /// The nearest of these primitives that the ray meets.
  Hit<Real> among(const Ray<Real>& ray, std::span<const std::uint32_t> primitives) const;

  /// A ray with what its tests have in common.
  struct Query {
    const Ray<Real>& ray;
    Real a = 0;           // D.D
    Shear<Real> shear{};  // only triangles need it
  };
  /// Tests one primitive; if the ray meets it in its range and nearer than `best`, it becomes `best` (judge()).
  bool test(const Query& query, std::uint32_t index, Hit<Real>& best) const;
  /// The ray as accelerators take it.
  CandidateRay<Real> candidate(const Ray<Real>& ray) const {
    return {ray.origin, ray.direction, inputs_.box_padding * reach(ray), inputs_.slab_form};
  }
  /// The largest coordinate, of the scene or of the ray's origin, as boxes are seen.
  Real reach(const Ray<Real>& ray) const {
    if (inputs_.slab_form != SlabForm::from_ray) return std::max(geometry_.reach, largest_component(ray.origin));
    return std::max(geometry_.seen.reach, largest_component(ray.origin - geometry_.seen.centre));
  }

 private:
  enum class Find { nearest, any };
  Hit<Real> search(const Ray<Real>& ray, Find find) const;
  void search_embree(const EmbreeGeometry<Real>& embree, const Query& query, Find find, Hit<Real>& best) const;
  void prepare(Query& query) const;

  /// `primitive` has the number `index`.
  bool test(const Query& query, std::uint32_t index, const Primitive& primitive, Hit<Real>& best) const;
  bool test_sphere(const Query& query, std::uint32_t index, const Primitive& primitive, Hit<Real>& best) const;
  bool test_triangle(const Query& query, std::uint32_t index, const Primitive& primitive, Hit<Real>& best) const;
  bool test_solid(const Query& query, std::uint32_t index, const Primitive& primitive, Hit<Real>& best) const;
  /// Is t in the ray's range, and better than what is known? Not for NaN.
  /// Reports that a primitive is not tested, since the ray leaves it.
  void report_excluded(const Primitive& primitive) const;
  static TestOutcome judge(const Ray<Real>& ray, Real t, std::uint32_t index, const Hit<Real>& best);

  SphereRoots<Real> sphere_roots(const Query& query, std::uint32_t index, const TracedSphere<Real>& sphere) const;
  TriangleResult<Real> triangle_result(const Query& query, std::uint32_t index,
                                       const TracedTriangle<Real>& triangle) const;
  /// For a triangle that asks_for_double() and on which the ray does not start.
  TriangleResult<Real> result_in_double(const Query& query, const TracedTriangle<Real>& triangle) const;
  /// For a sphere or a ray whose squares leave the range of Real. Of the discriminant only its sign is given.
  SphereRoots<Real> roots_in_double(const Ray<Real>& ray, bool starts, const TracedSphere<Real>& sphere) const;
  LineSpan<Real> span_of(const Query& query, std::uint32_t index, const TracedSolid& solid, std::size_t part) const;
  /// A form on its own has up to two crossings, of which flat ones keep only the finite one.
  Crossings<Real> crossings_of(const Query& query, std::uint32_t index, const TracedSolid& solid) const;

  static TriangleTestEvent triangle_event(const PixelId& id, TestOutcome outcome, const TriangleResult<Real>& result,
                                          bool own_surface);
  SolidTestEvent solid_event(const Query& query, std::uint32_t index, const Primitive& primitive, TestOutcome outcome,
                             const Crossings<Real>& crossings) const;

  const TraceInputs<Real>& inputs_;
  const TracedGeometry<Real>& geometry_;
  Recorder& recorder_;
};

// Defined in intersector-inl.h, compiled in intersector.cpp.
extern template class Intersector<float, Silent>;
extern template class Intersector<float, CountingRecorder>;
extern template class Intersector<float, PixelRecorder>;
extern template class Intersector<double, Silent>;
extern template class Intersector<double, CountingRecorder>;
extern template class Intersector<double, PixelRecorder>;

}  // namespace ps
