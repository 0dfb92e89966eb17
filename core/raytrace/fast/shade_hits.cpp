#include "raytrace/fast/shade_hits.h"

#include "options/simd_choice.h"

// This file is compiled once for each SIMD target. Only the two with eight lanes are kept.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raytrace/fast/shade_hits.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
#include "shade/illumination-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, shaded_together>;
using I = hn::RebindToSigned<D>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
using P = Vec3Lanes<D>;

HWY_INLINE P load(const std::array<HitPacket::Lanes, 3>& from) {
  const D d;
  return {hn::Load(d, from[0].data()), hn::Load(d, from[1].data()), hn::Load(d, from[2].data())};
}
HWY_INLINE void store(const P& value, std::array<HitPacket::Lanes, 3>& to) {
  const D d;
  hn::Store(value.x, d, to[0].data());
  hn::Store(value.y, d, to[1].data());
  hn::Store(value.z, d, to[2].data());
}

/// Scalar `place` and the two after it of the rows that begin at `first`.
HWY_INLINE P gather(const float* rows, hn::Vec<I> first, int place) {
  const D d;
  const auto at = [&](int offset)
                      HWY_ATTR { return hn::GatherIndex(d, rows, hn::Add(first, hn::Set(I(), place + offset))); };
  return {at(0), at(1), at(2)};
}

HWY_INLINE P blended(const P& a, const P& b, const P& c, const P& weights) {
  return add(add(scale(a, weights.x), scale(b, weights.y)), scale(c, weights.z));
}

/// triangle_normal(), which is asked itself for the few whose square float does not hold.
HWY_INLINE P triangle_normals(const P& a, const P& b, const P& c) {
  const D d;
  const P normal = cross(subtract(b, a), subtract(c, a));
  if (HWY_LIKELY(factors_for_squares<D>(dot(normal, normal)).all_one)) return normal;
  alignas(32) std::array<HitPacket::Lanes, 3> corners[3], normals;
  store(a, corners[0]);
  store(b, corners[1]);
  store(c, corners[2]);
  for (std::size_t i = 0; i < shaded_together; ++i) {
    const auto corner = [&](const std::array<HitPacket::Lanes, 3>& of) { return Vec3f(of[0][i], of[1][i], of[2][i]); };
    const Vec3f own = triangle_normal(corner(corners[0]), corner(corners[1]), corner(corners[2]));
    for (std::size_t axis = 0; axis < 3; ++axis) normals[axis][i] = own[static_cast<int>(axis)];
  }
  return load(normals);
}

/// put_triangle_surface(), as far as shading needs it.
void place(const HitTables& tables, HitPacket& packet) {
  const D d;
  const I i;
  const P weights = load(packet.weights);
  const float* const triangles = packet.own_triangles ? packet.own_triangles : tables.triangles;
  const float* const all_attributes = packet.own_attributes ? packet.own_attributes : tables.attributes;
  const auto triangle = hn::Mul(hn::Load(i, packet.triangle.data()), hn::Set(i, 10));
  const P a = gather(triangles, triangle, 0), b = gather(triangles, triangle, 3), c = gather(triangles, triangle, 6);
  store(blended(a, b, c, weights), packet.point);
  const auto attributes = hn::Load(i, packet.attributes.data());
  const M carried = hn::RebindMask(d, hn::Gt(attributes, hn::Set(i, -1)));
  M usable = carried;
  P normal{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  if (!hn::AllFalse(d, carried)) {
    const auto row = hn::Mul(hn::Max(attributes, hn::Zero(i)), hn::Set(i, 16));
    const P corners = blended(gather(all_attributes, row, 0), gather(all_attributes, row, 3),
                              gather(all_attributes, row, 6), weights);
    const P unit = normalised(corners);
    usable = hn::And(carried, hn::Gt(dot(unit, unit), hn::Zero(d)));
    normal = tables.renormalise ? unit : corners;
  }
  if (!hn::AllTrue(d, usable)) {
    const P face = scale(normalised(triangle_normals(a, b, c)), hn::Load(d, packet.sense.data()));
    normal = choose(usable, normal, face);
  }
  store(normal, packet.normal);
}

/// illuminate() for the materials that HitTables takes.
HWY_INLINE P light_at(const HitTables& tables, const std::vector<unsigned>& blocked, const HitPacket& packet,
                      V exponent, V faint, M specular) {
  const D d;
  const V zero = hn::Zero(d);
  P sum{zero, zero, zero};
  const P normal = load(packet.normal);
  const LitLanes<D> points{load(packet.point), normal, load(packet.to_eye), length_of(normal), specular,
                           exponent,           faint,  tables.highlight};
  for (std::size_t k = 0; k < tables.lights.size(); ++k) {
    const ShadingLight<float>& light = tables.lights[k];
    if (light.kind == LightKind::ambient) {
      add_light(sum, hn::Eq(zero, zero), light.colour, hn::Set(d, light.intensity));
      continue;
    }
    const std::uint8_t bits[8] = {static_cast<std::uint8_t>(~blocked[k])};
    add_casting_light(light, points, hn::LoadMaskBits(d, bits), sum);
  }
  return sum;
}

void light(const HitTables& tables, const std::vector<unsigned>& blocked, HitPacket& packet) {
  const D d;
  const I i;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  static_assert(sizeof(HitMaterial) == 8 * sizeof(float));
  const auto row = hn::ShiftLeft<3>(hn::Load(i, packet.material.data()));
  const float* const materials = &tables.materials[0].red;
  const P colour = gather(materials, row, 0), rest = gather(materials, row, 3);
  P sum{one, one, one};
  if (tables.lighting) sum = light_at(tables, blocked, packet, rest.x, rest.y, hn::Gt(rest.z, zero));
  store({hn::Add(hn::Mul(colour.x, sum.x), zero), hn::Add(hn::Mul(colour.y, sum.y), zero),
         hn::Add(hn::Mul(colour.z, sum.z), zero)},
        packet.colour);
}

}  // namespace

constexpr HitFunctions all_hit_functions{place, light};

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace ps {

HitFunctions hit_functions(Simd simd) { return PS_CHOSEN_WIDE_KERNEL(HitFunctions, simd, all_hit_functions); }

}  // namespace ps
#endif
