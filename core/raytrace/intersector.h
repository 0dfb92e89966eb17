#pragma once
#include <algorithm>
#include <optional>
#include <span>

#include "accel/none.h"
#include "raytrace/csg.h"
#include "raytrace/sphere_robust.h"
#include "raytrace/trace_inputs.h"
#include "raytrace/triangle_moeller_trumbore.h"
#include "raytrace/triangle_plane.h"
#include "raytrace/triangle_watertight.h"
#include "record/recorder.h"

namespace ps {

/// Which primitive does a ray meet? The nearest one (ties: the lowest), or any at all. CGFS ch. 2 and 5.
template <class Real, class Recorder>
class Intersector {
 public:
  Intersector(const TraceInputs<Real>& inputs, Recorder& recorder)
      : inputs_(inputs), geometry_(*inputs.geometry), recorder_(recorder) {}

  Hit<Real> nearest(const Ray<Real>& ray) const { return find(ray, false); }
  Hit<Real> any(const Ray<Real>& ray) const { return find(ray, true); }
  /// nearest() of each ray; faster for rays of neighbouring pixels.
  void nearest(std::span<const Ray<Real>> rays, std::span<Hit<Real>> hits) const {
    for (std::size_t first = 0; first < rays.size(); first += packet_width) {
      const std::size_t count = std::min(packet_width, rays.size() - first);
      const auto some = rays.subspan(first, count);
      if constexpr (std::is_same_v<Real, float>) {
        if (!recorder_.collects() && suits_together(some)) {
          search_together(some, hits.subspan(first, count));
          continue;
        }
        if (!recorder_.collects() && inputs_.list) {
          search_list_together(some, hits.subspan(first, count));
          continue;
        }
      }
      for (std::size_t i = 0; i < count; ++i) hits[first + i] = nearest(some[i]);
    }
  }
  /// Whether the ray meets this primitive; found() or not.
  Hit<Real> one(const Ray<Real>& ray, std::uint32_t primitive) const { return among(ray, std::span(&primitive, 1)); }
  /// The nearest of these primitives that the ray meets.
  Hit<Real> among(const Ray<Real>& ray, std::span<const std::uint32_t> primitives) const {
    Hit<Real> best;
    best.t = ray.t_max;
    Query query{ray};
    prepare(query);
    for (const std::uint32_t primitive : primitives) test(query, primitive, best);
    return best;
  }

 private:
  /// A ray with what its tests have in common.
  struct Query {
    const Ray<Real>& ray;
    Real a = 0;  // D.D
    Shear<Real> shear{};
  };

  void prepare(Query& query) const {
    query.a = dot(query.ray.direction, query.ray.direction);
    if (!geometry_.triangles.empty() || shares_meshes(geometry_)) query.shear = Shear<Real>(query.ray.direction);
  }

  /// search(), with a short way for triangles alone.
  Hit<Real> find(const Ray<Real>& ray, bool any) const {
    if constexpr (std::is_same_v<Real, float>)
      if (inputs_.wide && inputs_.only_triangles && !recorder_.collects() && suits_wide(ray)) {
        Hit<Real> best;
        best.t = ray.t_max;
        search_wide_triangles(ray, any, best);
        return best;
      }
    return search(ray, any);
  }

  Hit<Real> search(const Ray<Real>& ray, bool any) const {
    Hit<Real> best;
    best.t = ray.t_max;
    Query query{ray};
    const bool cached = inputs_.settings.cache_constants;
    const auto visit = [&](std::uint32_t primitive) {
      if (!cached) prepare(query);
      return test(query, primitive, best) && any;
    };
    if (inputs_.settings.accelerator != Accelerator::none && !geometry_.unbounded.empty()) {
      prepare(query);
      for (const std::uint32_t primitive : geometry_.unbounded)
        if (visit(primitive)) return best;
    }
    if constexpr (std::is_same_v<Real, float>) {
      if (inputs_.list && !recorder_.collects()) {
        query.a = dot(ray.direction, ray.direction);
        search_list(query, visit, any, best);
        return best;
      }
      if (inputs_.wide && !recorder_.collects() && suits_wide(ray)) {
        query.a = dot(ray.direction, ray.direction);
        search_wide(query, visit, any, best);
        return best;
      }
    }
    prepare(query);
    if constexpr (std::is_same_v<Real, float>) {
      if (inputs_.simple.embree) {
        search_embree(query, visit, any, best);
        return best;
      }
    }
    if (inputs_.simple.two_level) {
      const auto visit_known = [&](std::uint32_t number, const Primitive& primitive) {
        if (!cached) prepare(query);
        return test(query, number, primitive, best) && any;
      };
      const CandidateRay<Real> candidate{ray.origin, ray.direction, padding(ray), padded_slabs(ray)};
      for_each_candidate(*inputs_.simple.two_level, geometry_, candidate, best.t, visit_known, recorder_);
      return best;
    }
    if (inputs_.simple.any()) {
      search_simple(ray, visit, best);
      return best;
    }
    if (!inputs_.bvh) {
      const NoAccelerator all{primitive_count(geometry_)};
      for_each_candidate(all, SlabRay<Real>(), best.t, visit, recorder_);
      return best;
    }
    SlabRay<Real> slabs;
    if (inputs_.bvh->nodes.size() > 1) slabs = padded_slabs(ray);
    for_each_candidate(*inputs_.bvh, slabs, best.t, visit, recorder_);
    return best;
  }

  /// The largest coordinate, of the scene or of the ray's origin.
  Real reach(const Ray<Real>& ray) const {
    const Vec3<Real>& o = ray.origin;
    return std::max({geometry_.reach, std::abs(o.x), std::abs(o.y), std::abs(o.z)});
  }
  Real padding(const Ray<Real>& ray) const { return inputs_.box_padding * reach(ray); }
  SlabRay<Real> padded_slabs(const Ray<Real>& ray) const {
    if (inputs_.settings.slab_test == SlabTest::naive)
      return SlabRay<Real>(ray.origin, ray.direction, 0, SlabForm::naive);
    return SlabRay<Real>(ray.origin, ray.direction, padding(ray));
  }

  template <class Visit>
  void search_simple(const Ray<Real>& ray, Visit&& visit, const Hit<Real>& best) const {
    const CandidateRay<Real> candidate{ray.origin, ray.direction, padding(ray), padded_slabs(ray)};
    const SimpleAccelerators<Real>& simple = inputs_.simple;
    if (simple.spheres) for_each_candidate(*simple.spheres, candidate, best.t, visit, recorder_);
    if (simple.box) for_each_candidate(*simple.box, candidate, best.t, visit, recorder_);
    if (simple.octree) for_each_candidate(*simple.octree, candidate, best.t, visit, recorder_);
  }

  /// Primitives other than triangles first, in their own tree. If our test accepts a triangle that Embree offers, it
  /// provides t and weights. Where ours sees the ray pass by, Embree decides, or the ray could slip through between the
  /// two; such hits are counted.
  template <class Visit>
  void search_embree(const Query& query, Visit&& visit, bool any, Hit<Real>& best) const {
    const EmbreeGeometry& embree = *inputs_.simple.embree;
    if (!embree.others.nodes.empty()) {
      for_each_candidate(embree.others, padded_slabs(query.ray), best.t, visit, recorder_);
      if (any && best.found()) return;
    }
    if (!embree.triangles) return;
    embree.triangles->for_each_candidate(query.ray, best.t, any, [&](const EmbreeCandidate& candidate) {
      if (test(query, candidate.primitive, best)) return true;
      const Primitive& primitive = geometry_.primitives[candidate.primitive];
      const TracedTriangle<Real>& triangle = geometry_.triangles[primitive.shape];
      const TriangleVerdict verdict = triangle_result(query, candidate.primitive, triangle).verdict;
      if (verdict != TriangleVerdict::outside && verdict != TriangleVerdict::parallel) return false;
      if (query.ray.passes_transparent && inputs_.materials[primitive.material].passes_light()) return false;
      if (primitive.front_only && sees_back(query.ray.direction, primitive, triangle)) return false;
      if (judge(query.ray, candidate.t, candidate.primitive, best) != TestOutcome::accepted) return false;
      recorder_.count(Counter::edge_rays);
      best = {candidate.primitive, candidate.t, candidate.weights, 0};
      return true;
    });
  }

  /// The arithmetic of the wide tree's boxes must not overflow: no direction that is tiny beside the scene, no NaN.
  bool suits_wide(const Ray<Real>& ray) const {
    const Vec3<Real>& d = ray.direction;
    return reach(ray) < Real(1e15) * std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }

  /// The fast path: what is not a triangle first, in its own tree, then the triangles with SIMD.
  template <class Visit>
  void search_wide(const Query& query, Visit&& visit, bool any, Hit<Real>& best) const {
    if (!inputs_.wide->others.nodes.empty()) {
      for_each_candidate(inputs_.wide->others, padded_slabs(query.ray), best.t, visit, recorder_);
      if (any && best.found()) return;
    }
    search_wide_triangles(query.ray, any, best);
  }
  void search_wide_triangles(const Ray<Real>& ray, bool any, Hit<Real>& best) const {
    const WideSearches& searches = inputs_.wide_searches;
    WideCount count;
    (any ? searches.any : searches.nearest)(inputs_.wide->triangles, {ray, padding(ray), inputs_.triangle_epsilon},
                                            best, count);
    recorder_.count(Counter::node_visits, count.nodes);
    recorder_.count(Counter::triangle_tests, count.triangles);
  }

  bool suits_together(std::span<const Ray<Real>> rays) const {
    if (!inputs_.wide || !inputs_.packet_searches.nearest || !suits_packet(rays.data(), rays.size())) return false;
    return std::all_of(rays.begin(), rays.end(), [&](const Ray<Real>& ray) { return suits_wide(ray); });
  }

  /// search_wide() for up to packet_width rays; the last one fills lanes that are left over.
  void search_together(std::span<const Ray<Real>> rays, std::span<Hit<Real>> hits) const {
    WidePacket packet;
    WidePacketHits best;
    float pad = 0;
    packet.triangle_epsilon = inputs_.triangle_epsilon;
    for (std::size_t lane = 0; lane < packet_width; ++lane) {
      const Ray<Real>& ray = rays[std::min(lane, rays.size() - 1)];
      for (int axis = 0; axis < 3; ++axis) {
        packet.origin[static_cast<std::size_t>(axis)][lane] = ray.origin[axis];
        packet.direction[static_cast<std::size_t>(axis)][lane] = ray.direction[axis];
      }
      packet.t_min[lane] = ray.t_min;
      packet.t_max[lane] = ray.t_max;
      pad = std::max(pad, padding(ray));
    }
    packet.pad = pad;
    nearest_others(rays, packet, hits);
    for (std::size_t lane = 0; lane < packet_width; ++lane) {
      const std::size_t i = std::min(lane, rays.size() - 1);
      best.t[lane] = hits[i].t;
      best.primitive[lane] = static_cast<std::int32_t>(hits[i].primitive);
      for (std::size_t k = 0; k < 3; ++k) best.weights[k][lane] = hits[i].weights[k];
    }
    WideCount count;
    inputs_.packet_searches.nearest(inputs_.wide->triangles, packet, best, count);
    recorder_.count(Counter::node_visits, count.nodes);
    recorder_.count(Counter::triangle_tests, count.triangles);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto primitive = static_cast<std::uint32_t>(best.primitive[i]);
      if (primitive != hits[i].primitive)
        hits[i] = {primitive, best.t[i], {best.weights[0][i], best.weights[1][i], best.weights[2][i]}, 0};
    }
  }

  /// For each ray of a packet the nearest primitive that is not a triangle.
  void nearest_others(std::span<const Ray<Real>> rays, const WidePacket& packet, std::span<Hit<Real>> hits) const {
    const Bvh<float>& others = inputs_.wide->others;
    unsigned perhaps = others.nodes.empty() ? 0u : inputs_.packet_searches.meets(others.nodes[0].box, packet);
    if (!geometry_.unbounded.empty()) perhaps = ~0u;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      hits[i] = {};
      hits[i].t = rays[i].t_max;
      if ((perhaps >> i & 1u) != 0) hits[i] = nearest_other(rays[i]);
    }
  }

  /// The nearest primitive that is not a triangle.
  Hit<Real> nearest_other(const Ray<Real>& ray) const {
    Hit<Real> best;
    best.t = ray.t_max;
    Query query{ray};
    query.a = dot(ray.direction, ray.direction);
    const auto visit = [&](std::uint32_t primitive) { return test(query, primitive, best) && false; };
    for (const std::uint32_t primitive : geometry_.unbounded) visit(primitive);
    for_each_candidate(inputs_.wide->others, padded_slabs(ray), best.t, visit, recorder_);
    return best;
  }

  /// Everything is tested: what is not a triangle one by one, then the triangles with SIMD.
  template <class Visit>
  void search_list(const Query& query, Visit&& visit, bool any, Hit<Real>& best) const {
    for (const std::uint32_t primitive : inputs_.list->others)
      if (visit(primitive)) return;
    const WideQuery wide{query.ray, 0, inputs_.triangle_epsilon};
    const WideSearches& searches = inputs_.wide_searches;
    WideCount count;
    (any ? searches.list_any : searches.list_nearest)(inputs_.list->triangles, wide, best, count);
    recorder_.count(Counter::triangle_tests, count.triangles);
  }

  /// search_list() for up to most_list_queries rays.
  void search_list_together(std::span<const Ray<Real>> rays, std::span<Hit<Real>> hits) const {
    static_assert(packet_width <= most_list_queries);
    std::vector<WideQuery> queries;
    queries.reserve(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
      queries.push_back({rays[i], 0, inputs_.triangle_epsilon});
      hits[i] = among(rays[i], inputs_.list->others);
    }
    WideCount count;
    inputs_.wide_searches.list_nearest_of_many(inputs_.list->triangles, queries, hits, count);
    recorder_.count(Counter::triangle_tests, count.triangles);
  }

  bool test(const Query& query, std::uint32_t index, Hit<Real>& best) const {
    return test(query, index, primitive_of(geometry_, index), best);
  }

  bool test(const Query& query, std::uint32_t index, const Primitive& primitive, Hit<Real>& best) const {
    if (query.ray.passes_transparent && inputs_.materials[primitive.material].passes_light()) return false;
    switch (primitive.kind) {
    case PrimitiveKind::sphere:
      return test_sphere(query, index, primitive, best);
    case PrimitiveKind::triangle:
      return test_triangle(query, index, primitive, best);
    case PrimitiveKind::solid:
      return test_solid(query, index, primitive, best);
    }
    return false;
  }

  /// Is t in the ray's range, and better than what is known? Written so that NaN is not.
  static TestOutcome judge(const Ray<Real>& ray, Real t, std::uint32_t index, const Hit<Real>& best) {
    if (!(t > ray.t_min)) return TestOutcome::before_range;
    if (!(t < ray.t_max)) return TestOutcome::beyond_range;
    if (t > best.t) return TestOutcome::farther;
    if (t == best.t && best.found() && index > best.primitive) return TestOutcome::tie_lost;
    return TestOutcome::accepted;
  }

  bool test_sphere(const Query& query, std::uint32_t index, const Primitive& primitive, Hit<Real>& best) const {
    recorder_.count(Counter::sphere_tests);
    const Ray<Real>& ray = query.ray;
    const SphereRoots<Real> roots = sphere_roots(query, index, geometry_.spheres[primitive.shape]);
    TestOutcome outcome = TestOutcome::missed;
    if (roots.discriminant >= 0) {
      const bool enters = roots.near > ray.t_min;
      const Real t = enters ? roots.near : roots.far;
      outcome = judge(ray, t, index, best);
      if (outcome == TestOutcome::accepted) best = {index, t, {}, enters ? 0 : leaves_sphere};
    }
    recorder_.event([&] {
      SphereTestEvent event{primitive.id, outcome, static_cast<double>(roots.discriminant), {}};
      if (roots.discriminant >= 0)
        event.roots = std::array{static_cast<double>(roots.near), static_cast<double>(roots.far)};
      return event;
    });
    return outcome == TestOutcome::accepted;
  }

  SphereRoots<Real> sphere_roots(const Query& query, std::uint32_t index, const TracedSphere<Real>& sphere) const {
    const Ray<Real>& ray = query.ray;
    if (index == ray.start) return sphere_from_surface(ray.origin, ray.direction, query.a, sphere);
    switch (inputs_.settings.sphere_test) {
    case SphereTest::robust:
      return sphere_robust(ray.origin, ray.direction, query.a, sphere);
    case SphereTest::quadratic:
      return sphere_quadratic(ray.origin, ray.direction, query.a, sphere);
    }
    return {};
  }

  TriangleResult<Real> triangle_result(const Query& query, std::uint32_t index,
                                       const TracedTriangle<Real>& triangle) const {
    const Ray<Real>& ray = query.ray;
    TriangleResult<Real> result;
    if (index == ray.start) {  // a plane is met once: t = 0
      result.verdict = TriangleVerdict::guarded;
      return result;
    }
    switch (inputs_.settings.triangle_test) {
    case TriangleTest::watertight:
      return triangle_watertight(ray.origin, query.shear, triangle,
                                 ray.start == no_primitive ? TriangleGuard::none : TriangleGuard::rounding_of_t);
    case TriangleTest::moeller_trumbore:
      return triangle_moeller_trumbore(ray.origin, ray.direction, triangle, inputs_.triangle_epsilon);
    case TriangleTest::barycentric:
      return triangle_barycentric(ray.origin, ray.direction, triangle, inputs_.triangle_epsilon);
    case TriangleTest::cross_products:
      return triangle_cross_products(ray.origin, ray.direction, triangle, inputs_.triangle_epsilon);
    }
    return result;
  }

  bool test_triangle(const Query& query, std::uint32_t index, const Primitive& primitive, Hit<Real>& best) const {
    TracedTriangle<Real> placed;
    const TracedTriangle<Real>& triangle = triangle_of(geometry_, primitive, placed);
    if (shares_meshes(geometry_) && !has_area(triangle)) return false;  // unfolding leaves it out
    recorder_.count(Counter::triangle_tests);
    const TriangleResult<Real> result = triangle_result(query, index, triangle);
    TestOutcome outcome = TestOutcome::missed;
    switch (result.verdict) {
    case TriangleVerdict::inside:
      if (primitive.front_only && sees_back(query.ray.direction, primitive, triangle))
        outcome = TestOutcome::back_side;
      else
        outcome = judge(query.ray, result.t, index, best);
      break;
    case TriangleVerdict::outside:
      outcome = TestOutcome::missed;
      break;
    case TriangleVerdict::parallel:
      outcome = TestOutcome::parallel;
      break;
    case TriangleVerdict::guarded:
      outcome = TestOutcome::before_range;
      break;
    }
    if (outcome == TestOutcome::accepted) best = {index, result.t, result.weights, 0};
    recorder_.event([&] { return triangle_event(primitive.id, outcome, result, index == query.ray.start); });
    return outcome == TestOutcome::accepted;
  }

  LineSpan<Real> span_of(const Query& query, std::uint32_t index, const TracedSolid& solid, std::size_t part) const {
    const Ray<Real>& ray = query.ray;
    const bool starts = index == ray.start && detail_part(ray.start_detail) == part;
    return part_line(geometry_, geometry_.forms[solid.first_form + part], ray.origin, ray.direction, query.a,
                     inputs_.settings.sphere_test, starts ? detail_face(ray.start_detail) : no_face);
  }

  /// A form on its own has up to two crossings, of which flat ones keep only the finite one.
  Crossings<Real> crossings_of(const Query& query, std::uint32_t index, const TracedSolid& solid) const {
    const auto spans = [&](std::size_t part) { return span_of(query, index, solid, part); };
    if (solid.steps > 0)
      return csg_crossings<Real>(solid.forms, std::span(geometry_.steps).subspan(solid.first_step, solid.steps), spans);
    Crossings<Real> crossings;
    const LineSpan<Real> span = spans(0);
    if (span.empty) return crossings;
    const auto add = [&](Real t, int face, bool enters) {
      if (std::isfinite(t)) crossings.list[crossings.count++] = {t, solid_detail(0, face, false), enters};
    };
    add(span.enter, span.enter_face, true);
    add(span.leave, span.leave_face, false);
    return crossings;
  }

  /// The first crossing in the ray's range counts (CGFS ch. 5).
  bool test_solid(const Query& query, std::uint32_t index, const Primitive& primitive, Hit<Real>& best) const {
    recorder_.count(Counter::solid_tests);
    const TracedSolid& solid = geometry_.solids[primitive.shape];
    const Crossings<Real> crossings = crossings_of(query, index, solid);
    const FormKind kind = geometry_.forms[solid.first_form].kind;
    TestOutcome outcome = TestOutcome::missed;
    for (std::size_t i = 0; i < crossings.count; ++i) {
      const Crossing<Real>& crossing = crossings.list[i];
      bool from_behind = !crossing.enters;
      if (kind == FormKind::rectangle)
        from_behind = dot(query.ray.direction, geometry_.forms[solid.first_form].axes[2]) > 0;
      outcome = judge(query.ray, crossing.t, index, best);
      if (outcome == TestOutcome::before_range) continue;
      if (primitive.front_only && from_behind) {
        outcome = TestOutcome::back_side;
        continue;
      }
      if (outcome == TestOutcome::accepted) best = {index, crossing.t, {}, crossing.detail};
      break;
    }
    recorder_.event([&] { return solid_event(query, index, primitive, outcome, crossings); });
    return outcome == TestOutcome::accepted;
  }

  SolidTestEvent solid_event(const Query& query, std::uint32_t index, const Primitive& primitive, TestOutcome outcome,
                             const Crossings<Real>& crossings) const {
    SolidTestEvent event{primitive.id, outcome, {}, {}};
    const TracedSolid& solid = geometry_.solids[primitive.shape];
    for (std::size_t part = 0; part < solid.forms; ++part) {
      const LineSpan<Real> span = span_of(query, index, solid, part);
      if (!span.empty)
        event.spans.push_back(
            {static_cast<int>(part), static_cast<double>(span.enter), static_cast<double>(span.leave)});
    }
    for (std::size_t i = 0; i < crossings.count; ++i)
      event.crossings.push_back(static_cast<double>(crossings.list[i].t));
    return event;
  }

  static TriangleTestEvent triangle_event(const PixelId& id, TestOutcome outcome, const TriangleResult<Real>& result,
                                          bool own_surface) {
    TriangleTestEvent event;
    event.id = id;
    event.outcome = outcome;
    if (own_surface) event.rejected_by = "the ray's origin lies on it";
    if (own_surface || result.verdict == TriangleVerdict::parallel) return event;
    // Behind its start the ray does not need the guard: that is before its range by itself.
    if (result.verdict == TriangleVerdict::guarded && result.t >= 0)
      event.rejected_by = "t is within its rounding error of 0";
    if (outcome == TestOutcome::missed)
      event.rejected_by = "weight of vertex " + std::to_string(result.corner + 1) + " is negative";
    const auto& w = result.weights;
    event.weights = {static_cast<double>(w[0]), static_cast<double>(w[1]), static_cast<double>(w[2])};
    event.t = static_cast<double>(result.t);
    return event;
  }

  const TraceInputs<Real>& inputs_;
  const TracedGeometry<Real>& geometry_;
  Recorder& recorder_;
};

}  // namespace ps
