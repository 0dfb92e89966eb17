// Definitions of intersector.h for callers with a recorder of their own; intersector.cpp instantiates those of the
// program.
#pragma once
#include "raytrace/clear/intersector.h"

#include <string>

#include "base/overloaded.h"
#include "raytrace/clear/sphere_quadratic.h"
#include "raytrace/clear/triangle_query.h"

namespace ps {

template <class Real, class Recorder>
Hit<Real> Intersector<Real, Recorder>::nearest(const Ray<Real>& ray) const {
  return search(ray, Find::nearest);
}

template <class Real, class Recorder>
Hit<Real> Intersector<Real, Recorder>::any(const Ray<Real>& ray) const {
  return search(ray, Find::any);
}

template <class Real, class Recorder>
void Intersector<Real, Recorder>::nearest_of_each(std::span<const Ray<Real>> rays, std::span<Hit<Real>> hits) const {
  for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = nearest(rays[i]);
}

template <class Real, class Recorder>
Hit<Real> Intersector<Real, Recorder>::among(const Ray<Real>& ray, std::span<const std::uint32_t> primitives) const {
  Hit<Real> best;
  best.t = ray.t_max;
  Query query{ray};
  prepare(query);
  for (const std::uint32_t primitive : primitives) test(query, primitive, best);
  return best;
}

template <class Real, class Recorder>
void Intersector<Real, Recorder>::prepare(Query& query) const {
  query.a = dot(query.ray.direction, query.ray.direction);
  if (!geometry_.triangles.empty() || shares_meshes(geometry_)) query.shear = Shear<Real>(query.ray.direction);
}

// Unbounded primitives first, which no accelerator holds, then those that the accelerator names.
template <class Real, class Recorder>
Hit<Real> Intersector<Real, Recorder>::search(const Ray<Real>& ray, Find find) const {
  Hit<Real> best;
  best.t = ray.t_max;
  if (!is_searchable(ray)) return best;
  Query query{ray};
  prepare(query);
  const bool cached = inputs_.settings.cache_constants;
  const auto visit_known = [&](std::uint32_t number, const Primitive& primitive) {
    if (!cached) prepare(query);
    return test(query, number, primitive, best) && find == Find::any;
  };
  const auto visit = [&](std::uint32_t number) { return visit_known(number, primitive_of(geometry_, number)); };
  if (!std::holds_alternative<NoAccelerator>(inputs_.accelerator))
    for (const std::uint32_t primitive : geometry_.unbounded)
      if (visit(primitive)) return best;

  std::visit(
      Overloaded{
          [&](const NoAccelerator& all) { for_each_candidate(all, CandidateRay<Real>(), best.t, visit, recorder_); },
          [&](const std::shared_ptr<const EmbreeGeometry<Real>>& embree) { search_embree(*embree, query, find, best); },
          [&](const std::shared_ptr<const TwoLevel<Real>>& trees) {
            for_each_candidate(*trees, geometry_, candidate(ray), best.t, visit_known, recorder_);
          },
          [&](const std::shared_ptr<const BvhOnDemand<Real>>& bvh) {
            for_each_candidate(bvh->tree(), candidate(ray), best.t, visit, recorder_);
          },
          [&](const auto& tree) { for_each_candidate(*tree, candidate(ray), best.t, visit, recorder_); }},
      inputs_.accelerator);
  return best;
}

// Primitives other than triangles first, in their own tree. If our test accepts a triangle that Embree offers, it
// provides t and weights. Where ours sees the ray pass by, Embree decides, or the ray could slip through between the
// two; such hits are counted.
template <class Real, class Recorder>
void Intersector<Real, Recorder>::search_embree(const EmbreeGeometry<Real>& embree, const Query& query, Find find,
                                                Hit<Real>& best) const {
  const Ray<Real>& ray = query.ray;
  const bool any = find == Find::any;
  if (!embree.others.nodes.empty()) {
    const auto visit = [&](std::uint32_t primitive) { return test(query, primitive, best) && any; };
    for_each_candidate(embree.others, candidate(ray), best.t, visit, recorder_);
    if (any && best.found()) return;
  }
  if (!embree.triangles) return;
  const Ray<float> narrow{Vec3f(ray.origin), Vec3f(ray.direction), static_cast<float>(ray.t_min),
                          static_cast<float>(ray.t_max)};
  embree.triangles->for_each_candidate(narrow, static_cast<float>(best.t), any, [&](const EmbreeCandidate& offered) {
    if (test(query, offered.primitive, best)) return true;
    const Primitive& primitive = geometry_.primitives[offered.primitive];
    const TracedTriangle<Real>& triangle = geometry_.triangles[primitive.shape];
    const TriangleVerdict verdict = triangle_result(query, offered.primitive, triangle).verdict;
    if (verdict != TriangleVerdict::outside && verdict != TriangleVerdict::parallel) return false;
    if (ray.passes_transparent && inputs_.materials[primitive.material].passes_light()) return false;
    if (primitive.front_only && sees_back(ray.direction, primitive, triangle)) return false;
    if (judge(ray, Real(offered.t), offered.primitive, best) != TestOutcome::accepted) return false;
    recorder_.count(Counter::edge_rays);
    best = {offered.primitive, Real(offered.t), {}, 0};
    for (std::size_t k = 0; k < 3; ++k) best.weights[k] = Real(offered.weights[k]);
    return true;
  });
}

template <class Real, class Recorder>
bool Intersector<Real, Recorder>::test(const Query& query, std::uint32_t index, Hit<Real>& best) const {
  return test(query, index, primitive_of(geometry_, index), best);
}

template <class Real, class Recorder>
bool Intersector<Real, Recorder>::test(const Query& query, std::uint32_t index, const Primitive& primitive,
                                       Hit<Real>& best) const {
  if (query.ray.passes_transparent && inputs_.materials[primitive.material].passes_light()) return false;
  if (query.ray.excludes_start && index == query.ray.start) {
    report_excluded(primitive);
    return false;
  }
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

template <class Real, class Recorder>
void Intersector<Real, Recorder>::report_excluded(const Primitive& primitive) const {
  constexpr auto excluded = TestOutcome::excluded;
  switch (primitive.kind) {
  case PrimitiveKind::sphere:
    return recorder_.event([&] { return SphereTestEvent{primitive.id, excluded, 0, {}}; });
  case PrimitiveKind::triangle:
    return recorder_.event([&] { return TriangleTestEvent{primitive.id, excluded, {}, {}, {}}; });
  case PrimitiveKind::solid:
    return recorder_.event([&] { return SolidTestEvent{primitive.id, excluded, {}, {}}; });
  }
}

// Comparisons are written so that they fail for NaN.
template <class Real, class Recorder>
TestOutcome Intersector<Real, Recorder>::judge(const Ray<Real>& ray, Real t, std::uint32_t index,
                                               const Hit<Real>& best) {
  if (!(t > ray.t_min)) return TestOutcome::before_range;
  if (!(t < ray.t_max)) return TestOutcome::beyond_range;
  if (t > best.t) return TestOutcome::farther;
  if (t == best.t && best.found() && index > best.primitive) return TestOutcome::tie_lost;
  return TestOutcome::accepted;
}

template <class Real, class Recorder>
bool Intersector<Real, Recorder>::test_sphere(const Query& query, std::uint32_t index, const Primitive& primitive,
                                              Hit<Real>& best) const {
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

template <class Real, class Recorder>
SphereRoots<Real> Intersector<Real, Recorder>::sphere_roots(const Query& query, std::uint32_t index,
                                                            const TracedSphere<Real>& sphere) const {
  const Ray<Real>& ray = query.ray;
  if (!has_exact_square(query.a) || !has_exact_square(sphere.radius * sphere.radius))
    return roots_in_double(ray, index == ray.start, sphere);
  if (index == ray.start) return sphere_from_surface(ray.origin, ray.direction, query.a, sphere);
  switch (inputs_.settings.sphere_test) {
  case SphereTest::robust:
    return sphere_robust(ray.origin, ray.direction, query.a, sphere);
  case SphereTest::quadratic:
    return sphere_quadratic(ray.origin, ray.direction, query.a, sphere);
  }
  return {};
}

template <class Real, class Recorder>
TriangleResult<Real> Intersector<Real, Recorder>::triangle_result(const Query& query, std::uint32_t index,
                                                                  const TracedTriangle<Real>& triangle) const {
  if (index == query.ray.start) {  // a plane is met once: t = 0
    TriangleResult<Real> result;
    result.verdict = TriangleVerdict::guarded;
    return result;
  }
  return ps::triangle_result<Real>(inputs_.settings.triangle_test, {query.ray, query.shear, inputs_.triangle_epsilon},
                                   triangle);
}

template <class Real, class Recorder>
TriangleResult<Real> Intersector<Real, Recorder>::result_in_double(const Query& query,
                                                                   const TracedTriangle<Real>& triangle) const {
  const Ray<Real>& narrow = query.ray;
  const Ray<double> ray{Vec3d(narrow.origin), Vec3d(narrow.direction), 0, 0, narrow.start, false,
                        narrow.excludes_start};
  const TracedTriangle<double> wide{Vec3d(triangle.a), Vec3d(triangle.b), Vec3d(triangle.c)};
  const auto found = ps::triangle_result<double>(
      inputs_.settings.triangle_test,
      {ray, Shear<double>(ray.direction), static_cast<double>(inputs_.triangle_epsilon)}, wide);
  TriangleResult<Real> result;
  result.verdict = found.verdict;
  result.t = static_cast<Real>(found.t);
  for (std::size_t k = 0; k < 3; ++k) result.weights[k] = static_cast<Real>(found.weights[k]);
  result.corner = found.corner;
  return result;
}

template <class Real, class Recorder>
SphereRoots<Real> Intersector<Real, Recorder>::roots_in_double(const Ray<Real>& narrow, bool starts,
                                                               const TracedSphere<Real>& sphere) const {
  const Vec3d origin(narrow.origin), direction(narrow.direction);
  const TracedSphere<double> wide{Vec3d(sphere.centre), static_cast<double>(sphere.radius)};
  const double a = dot(direction, direction);
  SphereRoots<double> found;
  if (starts)
    found = sphere_from_surface(origin, direction, a, wide);
  else if (inputs_.settings.sphere_test == SphereTest::robust)
    found = sphere_robust(origin, direction, a, wide);
  else
    found = sphere_quadratic(origin, direction, a, wide);
  const Real sign = found.discriminant < 0 ? Real(-1) : Real(1);  // its size may leave the range of float
  return {std::isnan(found.discriminant) ? Real(-1) : sign, static_cast<Real>(found.near),
          static_cast<Real>(found.far)};
}

template <class Real, class Recorder>
bool Intersector<Real, Recorder>::test_triangle(const Query& query, std::uint32_t index, const Primitive& primitive,
                                                Hit<Real>& best) const {
  TracedTriangle<Real> placed;
  const TracedTriangle<Real>& triangle = triangle_of(geometry_, primitive, placed);
  if (shares_meshes(geometry_) && !has_area(triangle)) return false;  // unfolding leaves it out
  recorder_.count(Counter::triangle_tests);
  const bool in_double = primitive.in_double && index != query.ray.start &&
                         (!shares_meshes(geometry_) || asks_for_double(triangle, geometry_.near_plane));
  const TriangleResult<Real> result =
      in_double ? result_in_double(query, triangle) : triangle_result(query, index, triangle);
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

template <class Real, class Recorder>
LineSpan<Real> Intersector<Real, Recorder>::span_of(const Query& query, std::uint32_t index, const TracedSolid& solid,
                                                    std::size_t part) const {
  const Ray<Real>& ray = query.ray;
  const bool starts = index == ray.start && detail_part(ray.start_detail) == part;
  return part_line(geometry_, geometry_.forms[solid.first_form + part], ray.origin, ray.direction, query.a,
                   inputs_.settings.sphere_test, starts ? detail_face(ray.start_detail) : no_face);
}

template <class Real, class Recorder>
Crossings<Real> Intersector<Real, Recorder>::crossings_of(const Query& query, std::uint32_t index,
                                                          const TracedSolid& solid) const {
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

// The first crossing in the ray's range counts (CGFS ch. 5).
template <class Real, class Recorder>
bool Intersector<Real, Recorder>::test_solid(const Query& query, std::uint32_t index, const Primitive& primitive,
                                             Hit<Real>& best) const {
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

template <class Real, class Recorder>
SolidTestEvent Intersector<Real, Recorder>::solid_event(const Query& query, std::uint32_t index,
                                                        const Primitive& primitive, TestOutcome outcome,
                                                        const Crossings<Real>& crossings) const {
  SolidTestEvent event{primitive.id, outcome, {}, {}};
  const TracedSolid& solid = geometry_.solids[primitive.shape];
  for (std::size_t part = 0; part < solid.forms; ++part) {
    const LineSpan<Real> span = span_of(query, index, solid, part);
    if (!span.empty)
      event.spans.push_back({static_cast<int>(part), static_cast<double>(span.enter), static_cast<double>(span.leave)});
  }
  for (std::size_t i = 0; i < crossings.count; ++i) event.crossings.push_back(static_cast<double>(crossings.list[i].t));
  return event;
}

template <class Real, class Recorder>
TriangleTestEvent Intersector<Real, Recorder>::triangle_event(const PixelId& id, TestOutcome outcome,
                                                              const TriangleResult<Real>& result, bool own_surface) {
  TriangleTestEvent event;
  event.id = id;
  event.outcome = outcome;
  if (own_surface) event.rejected_by = "the ray's origin lies on it";
  if (own_surface || result.verdict == TriangleVerdict::parallel) return event;
  // Behind its start the ray does not need the guard: that is before its range by itself.
  if (result.verdict == TriangleVerdict::guarded && result.t >= 0)
    event.rejected_by = "t is within its rounding error of 0";
  if (outcome == TestOutcome::missed)
    event.rejected_by = "weight of vertex " + std::to_string(result.corner) + " is negative";
  const auto& w = result.weights;
  event.weights = {static_cast<double>(w[0]), static_cast<double>(w[1]), static_cast<double>(w[2])};
  event.t = static_cast<double>(result.t);
  return event;
}

}  // namespace ps
