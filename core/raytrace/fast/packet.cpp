#include "raytrace/fast/packet.h"

#include <bit>
#include <type_traits>

#include "options/simd_choice.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raytrace/fast/packet.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
#include "raytrace/fast/packet_reuse-inl.h"
#include "raytrace/fast/packet_search-inl.h"
#include "shade/illumination-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace {

struct Count {
  std::uint64_t rays = 0, shadow_rays = 0, reflection_rays = 0, sphere_tests = 0, shadings = 0, nan_pixels = 0;
  std::uint64_t searches_saved = 0, marks = 0, marks_shaded = 0;  // of subsampling
};

/// A hit point with what shading needs from its sphere, lane by lane.
struct PacketSurface {
  V3 point, normal, to_eye, colour;
  V reflective, exponent, faint;
  M specular;
};

HWY_INLINE PacketSurface surface_of(const PacketScene& scene, const PacketRay& ray, const PacketHit& hit) {
  const D d;
  const V3 zero = splat(Vec3f(0));
  PacketSurface surface{add(ray.origin, scale(ray.direction, hit.t)),
                        zero,
                        negate(ray.direction),
                        zero,
                        hn::Zero(d),
                        splat(1),
                        hn::Zero(d),
                        no_lane()};
  V3 centre = zero;
  for (std::size_t k = 0; k < scene.spheres.size(); ++k) {
    const M here = hn::Eq(hit.index, splat(static_cast<float>(k)));
    if (hn::AllFalse(d, here)) continue;
    const PacketSphere& sphere = scene.spheres[k];
    centre = choose(here, {splat(sphere.x), splat(sphere.y), splat(sphere.z)}, centre);
    surface.colour = choose(here, splat(sphere.colour), surface.colour);
    surface.reflective = hn::IfThenElse(here, splat(sphere.reflective), surface.reflective);
    surface.exponent = hn::IfThenElse(here, splat(sphere.exponent), surface.exponent);
    surface.faint = hn::IfThenElse(here, splat(sphere.faint), surface.faint);
    if (sphere.specular) surface.specular = hn::Or(surface.specular, here);
  }
  const V3 outwards = subtract(surface.point, centre);
  surface.normal = normalised(outwards);
  const M centred = hn::Eq(dot(outwards, outwards), hn::Zero(d));
  if (HWY_UNLIKELY(!hn::AllFalse(d, centred)))  // normal_towards()
    surface.normal = choose(hn::And(centred, hn::IsNaN(surface.normal.x)), normalised(surface.to_eye), surface.normal);
  return surface;
}

/// The direction away from the surface mirrored about the normal, given N.direction.
HWY_INLINE V3 mirror(const V3& direction, const V3& normal, V n_dot_direction) {
  return subtract(scale(normal, hn::Mul(splat(2), n_dot_direction)), direction);
}

/// Lanes that the light does not reach.
HWY_INLINE M shadowed(const PacketScene& scene, const PacketSurface& surface, V index, const V3& to_light, float t_max,
                      M active, Count& count) {
  const D d;
  if (!scene.shadows || hn::AllFalse(d, active)) return no_lane();
  count.shadow_rays += hn::CountTrue(d, active);
  const PacketRay ray{surface.point, to_light,     dot(to_light, to_light), index, hn::Zero(d),
                      splat(t_max),  From::surface};
  const Search kind = scene.any_hit ? Search::any : Search::nearest;
  return hn::Ge(search(scene, ray, active, kind, count.sphere_tests).index, hn::Zero(d));
}

/// By lane: bit i set where light i is blocked (TracedPixel::shadow_mask). Begins with bits = 0.
struct ShadowMasks {
  using Lanes = hn::Rebind<std::uint32_t, D>;
  hn::Vec<Lanes> bits;

  HWY_INLINE void add(std::size_t light, M blocked) {
    const Lanes d;
    if (light < 32) bits = hn::Or(bits, hn::IfThenElseZero(hn::RebindMask(d, blocked), hn::Set(d, 1u << light)));
  }
};
/// In place of masks where none are asked for.
struct NoShadowMasks {
  void add(std::size_t, M) {}
};

/// The illumination equation (shade/illumination.h) for surfaces without colours of their own for single terms. Adds
/// to `masks`.
template <class Masks>
HWY_INLINE V3 light_at(const PacketScene& scene, const PacketSurface& surface, V index, M active, Count& count,
                       Masks& masks) {
  const D d;
  const V zero = hn::Zero(d);
  V3 sum{zero, zero, zero};
  if (!scene.lighting) return splat(Vec3f(1));
  const LitLanes<D> points{surface.point,
                           surface.normal,
                           surface.to_eye,
                           length_of(surface.normal),
                           scene.highlights ? surface.specular : no_lane(),
                           surface.exponent,
                           surface.faint,
                           Highlight::phong};
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const ShadingLight<float>& light = scene.lights[i];
    if (light.kind == LightKind::ambient) {
      add_light(sum, hn::Eq(zero, zero), light.colour, splat(light.intensity));
      continue;
    }
    const bool is_point = light.kind == LightKind::point;
    const V3 to_light = is_point ? subtract(splat(light.vector), surface.point) : splat(light.vector);
    const float t_max = is_point ? 1.0f : std::numeric_limits<float>::infinity();
    const M asking = scene.useful_only ? hn::And(active, adds_light(points, to_light)) : active;
    const M blocked = shadowed(scene, surface, index, to_light, t_max, asking, count);
    masks.add(i, blocked);
    const M lit = hn::AndNot(blocked, asking);
    if (!hn::AllFalse(d, lit)) add_casting_light(light, points, lit, sum);
  }
  return sum;
}

/// What one bounce adds: colour = hit ? (mirrored ? local * (1 - r) + next * r : local) : background.
struct Bounce {
  V3 local;
  V reflective;
  M hit, mirrored;
};

HWY_INLINE V3 fold(const PacketScene& scene, const Bounce* bounces, int last) {
  V3 colour = splat(scene.background);
  for (int i = last; i >= 0; --i) {
    const Bounce& bounce = bounces[i];
    const V own = hn::Sub(splat(1), bounce.reflective);
    const V3 mixed = add(scale(bounce.local, own), scale(colour, bounce.reflective));
    colour = choose(bounce.mirrored, mixed, bounce.local);
    colour = choose(bounce.hit, colour, splat(scene.background));
  }
  return colour;
}

HWY_INLINE PacketHit find_nearest(const PacketScene& scene, const PacketRay& ray, M active, Count& count) {
  count.rays += hn::CountTrue(D(), active);
  return search(scene, ray, active, Search::nearest, count.sphere_tests);
}

/// Follows the eye rays of one packet, which hit `first`, through all bounces. `masks` are those of the first hits.
template <class Masks>
V3 trace(const PacketScene& scene, PacketRay ray, M active, const PacketHit& first, Count& count, Masks& masks) {
  const D d;
  Bounce bounces[65];
  int bounce = 0;
  PacketHit hit = first;
  V share = splat(1);
  while (true) {
    const M found = hn::And(active, hn::Ge(hit.index, hn::Zero(d)));
    Bounce& now = bounces[bounce];
    now.hit = found;
    now.mirrored = no_lane();
    if (hn::AllFalse(d, found)) return fold(scene, bounces, bounce);
    count.shadings += hn::CountTrue(d, found);
    const PacketSurface surface = surface_of(scene, ray, hit);
    NoShadowMasks none;
    const V3 light = std::is_same_v<Masks, NoShadowMasks> || bounce > 0
                         ? light_at(scene, surface, hit.index, found, count, none)
                         : light_at(scene, surface, hit.index, found, count, masks);
    const V zero = hn::Zero(d);
    now.local = {hn::Add(hn::Mul(surface.colour.x, light.x), zero), hn::Add(hn::Mul(surface.colour.y, light.y), zero),
                 hn::Add(hn::Mul(surface.colour.z, light.z), zero)};
    now.reflective = surface.reflective;
    share = hn::Mul(share, surface.reflective);
    const M mirrors = hn::And(hn::And(found, hn::Gt(surface.reflective, zero)), hn::Ge(share, splat(scene.cutoff)));
    if (bounce >= scene.depth || hn::AllFalse(d, mirrors)) return fold(scene, bounces, bounce);
    now.mirrored = mirrors;
    count.reflection_rays += hn::CountTrue(d, mirrors);
    V cosine = dot(surface.normal, surface.to_eye);
    cosine = hn::IfThenElse(hn::And(hit.enters, hn::Lt(cosine, zero)), zero, cosine);  // mirrored_direction()
    const V3 direction = mirror(surface.to_eye, surface.normal, cosine);
    ray = {surface.point, direction, dot(direction, direction),
           hit.index,     zero,      splat(std::numeric_limits<float>::infinity()),
           From::surface};
    active = mirrors;
    hit = find_nearest(scene, ray, active, count);
    ++bounce;
  }
}

/// Eye rays through centred canvas positions (Viewport::at).
HWY_INLINE PacketRay eye_rays(const PacketScene& scene, V canvas_x, V canvas_y) {
  const D d;
  const Viewport<float>& viewport = scene.viewport;
  const V vx = hn::Div(hn::Mul(canvas_x, splat(viewport.width)), splat(viewport.span_x));
  const V vy = hn::Div(hn::Mul(canvas_y, splat(viewport.height)), splat(viewport.span_y));
  const V3 across = add(scale(splat(scene.right), vx), scale(splat(scene.up), vy));
  const V3 direction = add(across, splat(scene.forward));
  return {splat(scene.eye), direction, dot(direction, direction), splat(-1), splat(scene.near),
          splat(scene.far), From::eye};
}

/// Those of pixels of a row.
HWY_INLINE PacketRay eye_rays_of_row(const PacketScene& scene, V column, int y) {
  const Viewport<float>& viewport = scene.viewport;
  const V canvas_x = hn::Sub(hn::Add(column, splat(static_cast<float>(viewport.sample.x))),
                             splat(static_cast<float>(viewport.columns) / 2.0f));
  const float canvas_y =
      canvas_position<float>(0, y, viewport.sample, viewport.columns, viewport.rows).y;  // the same for the row
  return eye_rays(scene, canvas_x, splat(canvas_y));
}

/// Places of samples, lane by lane.
struct SampleLanes {
  HWY_ALIGN float column[HWY_MAX_BYTES / 4], row[HWY_MAX_BYTES / 4];
  HWY_ALIGN float offset_x[HWY_MAX_BYTES / 4], offset_y[HWY_MAX_BYTES / 4];
};

/// Those through samples (canvas_position).
HWY_INLINE PacketRay eye_rays(const PacketScene& scene, const SampleLanes& places) {
  const D d;
  const Viewport<float>& viewport = scene.viewport;
  const V x = hn::Sub(hn::Add(hn::Load(d, places.column), hn::Load(d, places.offset_x)),
                      splat(static_cast<float>(viewport.columns) / 2.0f));
  const V y = hn::Sub(hn::Sub(splat(static_cast<float>(viewport.rows) / 2.0f), hn::Load(d, places.row)),
                      hn::Load(d, places.offset_y));
  return eye_rays(scene, x, y);
}

/// The results of one packet as plain numbers.
struct Lanes {
  HWY_ALIGN float red[HWY_MAX_BYTES / 4], green[HWY_MAX_BYTES / 4], blue[HWY_MAX_BYTES / 4];
  HWY_ALIGN float t[HWY_MAX_BYTES / 4], index[HWY_MAX_BYTES / 4];
};

HWY_INLINE void store_lanes(const V3& colour, const PacketHit& hit, Lanes& lanes) {
  const D d;
  hn::Store(colour.x, d, lanes.red);
  hn::Store(colour.y, d, lanes.green);
  hn::Store(colour.z, d, lanes.blue);
  hn::Store(hit.t, d, lanes.t);
  hn::Store(hit.index, d, lanes.index);
}

void add_counts(const PacketScene& scene, const Count& count, std::uint64_t eye_rays, Counters& counters) {
  counters[Counter::eye_rays] += eye_rays;
  counters[Counter::shadow_rays] += count.shadow_rays;
  counters[Counter::reflection_rays] += count.reflection_rays;
  counters[Counter::sphere_tests] += count.sphere_tests;
  counters[Counter::node_visits] += scene.tree ? count.rays + count.shadow_rays : 0;
  counters[Counter::searches_saved] += count.searches_saved;
  counters[Counter::shading_calls] += count.shadings;
  counters[Counter::light_samples] += scene.lighting ? count.shadings * scene.lights.size() : 0;
}

void store(const PacketScene& scene, const Lanes& lanes, int x, int y, int width, Frame& frame) {
  for (int i = 0; i < width; ++i) {
    frame.colour.at(x + i, y) = {lanes.red[i], lanes.green[i], lanes.blue[i]};
    const bool hit = lanes.index[i] >= 0;
    if (!frame.ids.empty())
      frame.ids.at(x + i, y) = hit ? scene.spheres[static_cast<std::size_t>(lanes.index[i])].id : PixelId{};
    if (!frame.depth.empty())
      frame.depth.at(x + i, y) = hit ? lanes.t[i] * scene.viewport.distance : std::numeric_limits<float>::infinity();
  }
}

void store(const ShadowMasks& masks, int x, int y, int width, Frame& frame) {
  HWY_ALIGN std::uint32_t bits[HWY_MAX_BYTES / 4];
  hn::Store(masks.bits, ShadowMasks::Lanes(), bits);
  for (int i = 0; i < width; ++i) frame.shadow.at(x + i, y) = bits[i];
}

/// The spheres that pixels of a row see.
void search_row(const PacketScene& scene, const std::vector<int>& columns, int y, float* found, Count& count) {
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  count.marks += columns.size();
  HWY_ALIGN float numbers[HWY_MAX_BYTES / 4];
  for (std::size_t first = 0; first < columns.size(); first += lanes) {
    const std::size_t width = std::min(lanes, columns.size() - first);
    for (std::size_t i = 0; i < lanes; ++i) numbers[i] = static_cast<float>(columns[first + std::min(i, width - 1)]);
    const PacketRay rays = eye_rays_of_row(scene, hn::Load(d, numbers), y);
    const PacketHit hit = find_nearest(scene, rays, hn::FirstN(d, width), count);
    hn::Store(hit.index, d, numbers);
    std::copy(numbers, numbers + width, found + first);
  }
}

/// Each ray is tested against what it probably meets, and against all where it does not. What is known by a search is
/// found again, uncounted.
HWY_INLINE PacketHit find_with_reuse(const PacketScene& scene, const PacketRay& rays, M active, V only, V searched,
                                     Count& count) {
  const D d;
  const V zero = hn::Zero(d);
  std::uint64_t tests = 0;
  PacketHit hit =
      search(scene, rays, hn::AndNot(hn::Eq(only, splat(every_sphere)), active), Search::nearest, tests, &only);
  const M known = hn::And(active, hn::Gt(searched, zero));
  count.sphere_tests += tests - hn::CountTrue(d, hn::And(known, hn::Ge(only, zero)));
  count.marks_shaded += hn::CountTrue(d, known);
  const M nothing = hn::Eq(only, splat(-1));
  const M met = hn::AndNot(known, hn::And(active, hn::Or(nothing, hn::Ge(hit.index, zero))));
  count.searches_saved += hn::CountTrue(d, met);
  const M missed = hn::AndNot(hn::Or(known, met), active);
  if (hn::AllFalse(d, missed)) return hit;
  const PacketHit all = find_nearest(scene, rays, missed, count);
  return {hn::IfThenElse(missed, all.t, hit.t), hn::IfThenElse(missed, all.index, hit.index),
          hn::Or(hn::And(missed, all.enters), hn::AndNot(missed, hit.enters))};
}

/// trace() that stores the shadows of its pixels, too. Apart, so that other pictures do not pay for it.
HWY_NOINLINE V3 trace_with_shadows(const PacketScene& scene, const PacketRay& rays, M active, const PacketHit& first,
                                   Count& count, int x, int y, int width, Frame& frame) {
  ShadowMasks masks;
  masks.bits = hn::Zero(ShadowMasks::Lanes());
  const V3 result = trace(scene, rays, active, first, count, masks);
  store(masks, x, y, width, frame);
  return result;
}

}  // namespace

void trace_packets(const PacketScene& scene, const TileRect& tile, const TileRect& part, Frame& frame,
                   Counters& counters) {
  const D d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  Lanes stored;
  Count count;
  NoShadowMasks none;
  const bool shadows = !frame.shadow.empty();
  const auto search_marks = [&](const std::vector<int>& columns, int y, float* found) {
    search_row(scene, columns, y, found, count);
  };
  std::optional<PacketReuse> reuse;
  PacketReuse::Row row{};
  if (scene.step > 1) reuse.emplace(tile, scene.step, search_marks);
  for (int y = part.y0; y < part.y1; ++y) {
    if (reuse) reuse->fill(y, row);
    for (int x = part.x0; x < part.x1; x += lanes) {
      const int width = std::min(lanes, part.x1 - x);
      const M active = hn::FirstN(d, static_cast<std::size_t>(width));
      const PacketRay rays = eye_rays_of_row(scene, hn::Add(hn::Iota(d, 0.0f), hn::Set(d, static_cast<float>(x))), y);
      PacketHit first;
      if (reuse) {
        const auto from = static_cast<std::size_t>(x - tile.x0);
        first = find_with_reuse(scene, rays, active, hn::LoadU(d, row.only + from), hn::LoadU(d, row.searched + from),
                                count);
      } else {
        first = find_nearest(scene, rays, active, count);
      }
      const V3 result = shadows ? trace_with_shadows(scene, rays, active, first, count, x, y, width, frame)
                                : trace(scene, rays, active, first, count, none);
      const M nan = hn::Or(hn::Or(hn::IsNaN(result.x), hn::IsNaN(result.y)), hn::IsNaN(result.z));
      count.nan_pixels += hn::CountTrue(d, hn::And(active, nan));
      store_lanes(result, first, stored);
      store(scene, stored, x, y, width, frame);
    }
  }
  const auto pixel_count = static_cast<std::uint64_t>(part.width()) * static_cast<std::uint64_t>(part.height());
  add_counts(scene, count, pixel_count + count.marks - count.marks_shaded, counters);
  counters[Counter::pixels_written] += pixel_count;
  counters[Counter::nan_pixels] += count.nan_pixels;
}

void trace_samples(const PacketScene& scene, std::span<const PacketSample> samples, std::span<PacketResult> results,
                   Counters& counters) {
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  Lanes stored;
  SampleLanes places;
  Count count;
  for (std::size_t first = 0; first < samples.size(); first += lanes) {
    const std::size_t width = std::min(lanes, samples.size() - first);
    for (std::size_t i = 0; i < lanes; ++i) {
      const PacketSample& sample = samples[first + std::min(i, width - 1)];
      places.column[i] = static_cast<float>(sample.column);
      places.row[i] = static_cast<float>(sample.row);
      places.offset_x[i] = sample.offset_x;
      places.offset_y[i] = sample.offset_y;
    }
    const PacketRay rays = eye_rays(scene, places);
    const M active = hn::FirstN(d, width);
    const PacketHit hit = find_nearest(scene, rays, active, count);
    NoShadowMasks none;
    const V3 result = trace(scene, rays, active, hit, count, none);
    store_lanes(result, hit, stored);
    for (std::size_t i = 0; i < width; ++i)
      results[first + i] = {
          {stored.red[i], stored.green[i], stored.blue[i]}, stored.t[i], static_cast<int>(stored.index[i])};
  }
  add_counts(scene, count, samples.size(), counters);
}

constexpr PacketFunctions all_packet_functions{trace_packets, trace_samples};

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace ps {

PacketFunctions packet_functions(Simd simd) { return PS_CHOSEN_KERNEL(PacketFunctions, simd, all_packet_functions); }

}  // namespace ps
#endif
