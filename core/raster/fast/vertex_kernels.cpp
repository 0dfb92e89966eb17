#include <algorithm>
#include <limits>

#include "options/simd_choice.h"
#include "raster/fast/vertices.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fast/vertex_kernels.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
#include "math/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<double>;
using DF = hn::Rebind<float, D>;
using DI = hn::Rebind<std::int32_t, D>;
using V = hn::Vec<D>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;

using V3 = ps::HWY_NAMESPACE::Vec3Lanes<D>;

HWY_INLINE V splat(double value) { return hn::Set(D(), value); }

/// matrix * v, as GLM multiplies.
HWY_INLINE V3 multiply(const Mat3d& m, const V3& v) {
  const auto row = [&](int i) HWY_ATTR {
    return hn::Add(hn::Add(hn::Mul(splat(m[0][i]), v.x), hn::Mul(splat(m[1][i]), v.y)), hn::Mul(splat(m[2][i]), v.z));
  };
  return {row(0), row(1), row(2)};
}

HWY_INLINE V3 load(const Vec3d* from) {
  V3 v;
  hn::LoadInterleaved3(D(), &from->x, v.x, v.y, v.z);
  return v;
}

struct Floats {
  VF x, y, z;
};

/// matrix * normal, length 1 (unless it has none).
HWY_INLINE Floats unit_normals(const Mat3d& matrix, const Vec3d* normals) {
  const V3 n = multiply(matrix, load(normals));
  const V3 unit = unit_or_zero(n);
  return {hn::DemoteTo(DF(), unit.x), hn::DemoteTo(DF(), unit.y), hn::DemoteTo(DF(), unit.z)};
}

constexpr std::size_t most_lanes = 8;

/// Normals and positions of a vector's vertices in turn.
HWY_INLINE void store_lit(const Floats& normal, const Floats& world, VF inverse_z, Vec4f* lit) {
  const DF df;
  const hn::FixedTag<float, 4> four;
  HWY_ALIGN std::array<float, 4 * most_lanes> normals, positions;
  hn::StoreInterleaved4(hn::Mul(normal.x, inverse_z), hn::Mul(normal.y, inverse_z), hn::Mul(normal.z, inverse_z),
                        hn::Zero(df), df, normals.data());
  hn::StoreInterleaved4(hn::Mul(world.x, inverse_z), hn::Mul(world.y, inverse_z), hn::Mul(world.z, inverse_z),
                        inverse_z, df, positions.data());
  for (std::size_t i = 0; i < hn::Lanes(df); ++i) {
    hn::StoreU(hn::Load(four, normals.data() + 4 * i), four, &lit[2 * i].x);
    hn::StoreU(hn::Load(four, positions.data() + 4 * i), four, &lit[2 * i + 1].x);
  }
}

/// Calls body(first) for whole vectors; the last one may overlap with the one before. Fewer elements than a vector are
/// copied to a place with room, and back.
template <class Body>
HWY_INLINE void for_vectors(std::size_t count, Body&& body) {
  const std::size_t lanes = hn::Lanes(D());
  for (std::size_t i = 0; i + lanes <= count; i += lanes) body(i);
  if (count % lanes != 0) body(count - lanes);
}

HWY_INLINE void transform_vector(const VertexTransform& t, const VertexInput& input, const VertexOutput& output,
                                 std::size_t first) {
  const DF df;
  const DI di;
  V3 p = multiply(t.linear, load(input.positions + first));
  p = {hn::Add(p.x, splat(t.translation.x)), hn::Add(p.y, splat(t.translation.y)),
       hn::Add(p.z, splat(t.translation.z))};
  const V3 in_world = p;
  p = multiply(t.from_world,
               {hn::Sub(p.x, splat(t.eye.x)), hn::Sub(p.y, splat(t.eye.y)), hn::Sub(p.z, splat(t.eye.z))});
  const VF x = hn::DemoteTo(df, p.x), y = hn::DemoteTo(df, p.y), z = hn::DemoteTo(df, p.z);
  const VF inverse_z = hn::Div(hn::Set(df, 1.0f), z);
  hn::StoreInterleaved4(x, y, z, inverse_z, df, &output.points[first].x);
  const Floats world{hn::DemoteTo(df, in_world.x), hn::DemoteTo(df, in_world.y), hn::DemoteTo(df, in_world.z)};
  if (output.world) hn::StoreInterleaved4(world.x, world.y, world.z, inverse_z, df, &output.world[first].x);
  if (output.lit)
    store_lit(unit_normals(t.normal_matrix, input.normals + first), world, inverse_z, output.lit + 2 * first);

  const VF column =
      hn::Add(hn::Set(df, t.projection.centre.x), hn::Div(hn::Mul(x, hn::Set(df, t.projection.scale.x)), z));
  const VF row = hn::Sub(hn::Set(df, t.projection.centre.y), hn::Div(hn::Mul(y, hn::Set(df, t.projection.scale.y)), z));
  const VF reach = hn::Set(df, static_cast<float>(guard_band));
  const VF most = hn::Set(df, std::numeric_limits<float>::max());
  const auto placed =
      hn::And(hn::And(hn::Le(hn::Abs(column), reach), hn::Le(hn::Abs(row), reach)), hn::Le(hn::Abs(inverse_z), most));
  VI outside = hn::IfThenZeroElse(hn::RebindMask(di, placed), hn::Set(di, std::numeric_limits<std::int32_t>::min()));
  for (std::size_t i = 0; i < t.plane_count; ++i) {
    const ClipPlane<float>& plane = t.planes[i];
    const VF distance =
        hn::Add(hn::Add(hn::Add(hn::Mul(hn::Set(df, plane.normal.x), x), hn::Mul(hn::Set(df, plane.normal.y), y)),
                        hn::Mul(hn::Set(df, plane.normal.z), z)),
                hn::Set(df, plane.offset));
    const auto front = hn::Ge(distance, hn::Zero(df));
    outside = hn::Or(outside, hn::IfThenZeroElse(hn::RebindMask(di, front), hn::Set(di, std::int32_t{1} << i)));
  }
  // to_fixed(): a multiple of a power of two is exact in float too, and rounding goes to even.
  const auto fixed = [&](VF position) HWY_ATTR {
    const VF inside = hn::IfThenElseZero(placed, position);
    return hn::ShiftLeft<1>(hn::NearestInt(hn::Mul(inside, hn::Set(df, t.subpixels))));
  };
  hn::StoreInterleaved4(fixed(column), fixed(row), outside, hn::Zero(di), di, &output.places[first].column);
}

HWY_INLINE void transform_normal_vector(const Mat3d& matrix, const Vec3d* normals, Vec4f* result) {
  const Floats unit = unit_normals(matrix, normals);
  hn::StoreInterleaved4(unit.x, unit.y, unit.z, hn::Zero(DF()), DF(), &result->x);
}

}  // namespace

static_assert(sizeof(Vec3d) == 3 * sizeof(double) && sizeof(Vec4f) == 16 && sizeof(VertexPlace) == 16);

void transform_positions(const VertexTransform& transform, const VertexInput& input, const VertexOutput& output) {
  if (input.count >= hn::Lanes(D())) {
    for_vectors(input.count, [&](std::size_t i) HWY_ATTR { transform_vector(transform, input, output, i); });
    return;
  }
  std::array<Vec3d, most_lanes> positions{}, normals{};
  std::array<Vec4f, most_lanes> points, world;
  std::array<Vec4f, 2 * most_lanes> lit;
  std::array<VertexPlace, most_lanes> places;
  std::copy_n(input.positions, input.count, positions.begin());
  if (input.normals) std::copy_n(input.normals, input.count, normals.begin());
  transform_vector(transform, {positions.data(), normals.data(), most_lanes},
                   {points.data(), places.data(), world.data(), output.lit ? lit.data() : nullptr}, 0);
  std::copy_n(points.begin(), input.count, output.points);
  std::copy_n(places.begin(), input.count, output.places);
  if (output.world) std::copy_n(world.begin(), input.count, output.world);
  if (output.lit) std::copy_n(lit.begin(), 2 * input.count, output.lit);
}

void transform_normals(const Mat3d& matrix, const Vec3d* normals, std::size_t count, Vec4f* result) {
  if (count >= hn::Lanes(D())) {
    for_vectors(count, [&](std::size_t i) HWY_ATTR { transform_normal_vector(matrix, normals + i, result + i); });
    return;
  }
  std::array<Vec3d, most_lanes> from{};
  std::array<Vec4f, most_lanes> to;
  std::copy_n(normals, count, from.begin());
  transform_normal_vector(matrix, from.data(), to.data());
  std::copy_n(to.begin(), count, result);
}

constexpr VertexKernels all_vertex_kernels{transform_positions, transform_normals};

}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace ps::raster {

VertexKernels vertex_kernels(Simd simd) { return PS_CHOSEN_KERNEL(VertexKernels, simd, all_vertex_kernels); }

}  // namespace ps::raster
#endif
