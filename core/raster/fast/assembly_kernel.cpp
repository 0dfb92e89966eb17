#include "options/simd_choice.h"
#include "raster/fast/assembly.h"

// This file is compiled once for each SIMD target. Only these three are kept; elsewhere the clear path does the work.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS HWY_SSSE3
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fast/assembly_kernel.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<float>;
using DI = hn::Rebind<std::int32_t, D>;
using V = hn::Vec<D>;
using VI = hn::Vec<DI>;
using M = hn::Mask<DI>;

constexpr int most_checked = 4;  ///< boxes up to this many samples on each side are tested here

struct Corner {
  V x, y, z, inverse_z;
  VI column, row, outside;
};

struct Edge {
  VI value, step_x, step_y, owned;  ///< value at the box's first sample; owned is 1 where ties belong to the edge
};

HWY_INLINE VI number(std::int32_t value) { return hn::Set(DI(), value); }
HWY_INLINE VI zero() { return hn::Zero(DI()); }

HWY_INLINE Corner load_corner(const CornerBlock& block, std::size_t k, std::size_t i) {
  Corner c;
  VI unused;
  hn::LoadInterleaved4(D(), &block.points[k][i].x, c.x, c.y, c.z, c.inverse_z);
  hn::LoadInterleaved4(DI(), &block.places[k][i].column, c.column, c.row, c.outside, unused);
  return c;
}

HWY_INLINE V dot(V ax, V ay, V az, V bx, V by, V bz) {
  return hn::Add(hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by)), hn::Mul(az, bz));
}

/// The triangle's normal in camera space is not null; and it looks towards the eye.
struct Facing {
  M solid, front;
};
HWY_INLINE Facing facing(const std::array<Corner, 3>& c, float handedness) {
  const D d;
  const V ax = hn::Sub(c[1].x, c[0].x), ay = hn::Sub(c[1].y, c[0].y), az = hn::Sub(c[1].z, c[0].z);
  const V bx = hn::Sub(c[2].x, c[0].x), by = hn::Sub(c[2].y, c[0].y), bz = hn::Sub(c[2].z, c[0].z);
  const V nx = hn::Sub(hn::Mul(ay, bz), hn::Mul(az, by));
  const V ny = hn::Sub(hn::Mul(az, bx), hn::Mul(ax, bz));
  const V nz = hn::Sub(hn::Mul(ax, by), hn::Mul(ay, bx));
  const V towards = dot(nx, ny, nz, hn::Neg(c[0].x), hn::Neg(c[0].y), hn::Neg(c[0].z));
  return {hn::RebindMask(DI(), hn::Gt(dot(nx, ny, nz, nx, ny, nz), hn::Zero(d))),
          hn::RebindMask(DI(), hn::Gt(hn::Mul(hn::Set(d, handedness), towards), hn::Zero(d)))};
}

/// Which edges own samples that lie on them.
HWY_INLINE VI owned(FillRule rule, VI dx, VI dy) {
  switch (rule) {
  case FillRule::top_left:
    return hn::IfThenElseZero(hn::Or(hn::Lt(dy, zero()), hn::And(hn::Eq(dy, zero()), hn::Gt(dx, zero()))), number(1));
  case FillRule::inclusive:
    return number(1);
  case FillRule::exclusive:
    return zero();
  }
  return zero();
}

/// The edge from a to b, with `sign` -1 where the triangle turns the other way, seen from the sample at (x, y).
HWY_INLINE Edge make_edge(const AssemblyRules& rules, const Corner& a, const Corner& b, VI sign, VI x, VI y) {
  const VI dx = hn::Mul(sign, hn::Sub(b.column, a.column));
  const VI dy = hn::Mul(sign, hn::Sub(b.row, a.row));
  const VI unit = number(std::int32_t{1} << (rules.subpixel_bits + 1));
  Edge edge;
  edge.value = hn::Sub(hn::Mul(dx, hn::Sub(y, a.row)), hn::Mul(dy, hn::Sub(x, a.column)));
  edge.step_x = hn::Neg(hn::Mul(dy, unit));
  edge.step_y = hn::Mul(dx, unit);
  edge.owned = owned(rules.fill_rule, dx, dy);
  return edge;
}

/// Whether any of size x size samples from the box's first on is covered, for boxes that are no larger.
HWY_INLINE M any_covered(const std::array<Edge, 3>& edges, VI width, VI height, int size) {
  M any = hn::Lt(zero(), zero());
  std::array<VI, 3> row{hn::Add(edges[0].value, edges[0].owned), hn::Add(edges[1].value, edges[1].owned),
                        hn::Add(edges[2].value, edges[2].owned)};
  for (int y = 0; y < size; ++y) {
    const M in_row = hn::Gt(height, number(y));
    std::array<VI, 3> value = row;
    for (int x = 0; x < size; ++x) {
      const VI least = hn::Min(hn::Min(value[0], value[1]), value[2]);
      any = hn::Or(any, hn::And(hn::And(hn::Gt(least, zero()), in_row), hn::Gt(width, number(x))));
      for (std::size_t i = 0; i < 3; ++i) value[i] = hn::Add(value[i], edges[i].step_x);
    }
    for (std::size_t i = 0; i < 3; ++i) row[i] = hn::Add(row[i], edges[i].step_y);
  }
  return any;
}

HWY_INLINE std::uint64_t bits_of(M mask) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(DI(), mask, bytes.data());
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < 2; ++i) bits |= std::uint64_t{bytes[i]} << (8 * i);
  return bits;
}

HWY_INLINE VI lowest(const VI& a, const VI& b, const VI& c) { return hn::Min(hn::Min(a, b), c); }
HWY_INLINE VI highest(const VI& a, const VI& b, const VI& c) { return hn::Max(hn::Max(a, b), c); }

HWY_INLINE void assemble_vector(const AssemblyRules& rules, const CornerBlock& block, std::size_t first, M wanted,
                                AssembledBlock& result) {
  const D d;
  const DI di;
  const std::array<Corner, 3> c{load_corner(block, 0, first), load_corner(block, 1, first),
                                load_corner(block, 2, first)};
  const Facing face = facing(c, rules.handedness);
  result.degenerate += hn::CountTrue(di, hn::AndNot(face.solid, wanted));
  M rest = hn::And(wanted, face.solid);
  if (rules.cull_backs) {
    result.back_facing += hn::CountTrue(di, hn::AndNot(face.front, rest));
    rest = hn::And(rest, face.front);
  }
  const VI low_x = lowest(c[0].column, c[1].column, c[2].column), low_y = lowest(c[0].row, c[1].row, c[2].row);
  const VI high_x = highest(c[0].column, c[1].column, c[2].column), high_y = highest(c[0].row, c[1].row, c[2].row);
  const M whole = hn::Eq(hn::Or(hn::Or(c[0].outside, c[1].outside), c[2].outside), zero());
  const M small =
      hn::And(hn::Lt(hn::Sub(high_x, low_x), number(rules.large)), hn::Lt(hn::Sub(high_y, low_y), number(rules.large)));
  const M here = hn::And(whole, small);
  result.left |= bits_of(hn::AndNot(here, rest)) << first;
  rest = hn::And(rest, here);
  if (hn::AllFalse(di, rest)) return;

  const VI area = hn::Sub(hn::Mul(hn::Sub(c[1].column, c[0].column), hn::Sub(c[2].row, c[0].row)),
                          hn::Mul(hn::Sub(c[1].row, c[0].row), hn::Sub(c[2].column, c[0].column)));
  const M flat = hn::Eq(area, zero());
  result.degenerate += hn::CountTrue(di, hn::And(flat, rest));
  rest = hn::AndNot(flat, rest);

  // sample_box(), cut to the picture
  const int shift = rules.subpixel_bits + 1;
  const VI sample_x = number(rules.sample_x), sample_y = number(rules.sample_y);
  const VI before_next = number((std::int32_t{1} << shift) - 1);
  const auto ceiling = [&](VI v, VI sample) HWY_ATTR {
    return hn::Max(hn::ShiftRightSame(hn::Add(hn::Sub(v, sample), before_next), shift), zero());
  };
  const auto next = [&](VI v, VI sample, int end) HWY_ATTR {
    return hn::Min(hn::Add(hn::ShiftRightSame(hn::Sub(v, sample), shift), number(1)), number(end));
  };
  const VI x0 = ceiling(low_x, sample_x), y0 = ceiling(low_y, sample_y);
  const VI width = hn::Sub(next(high_x, sample_x, rules.columns), x0);
  const VI height = hn::Sub(next(high_y, sample_y, rules.rows), y0);
  rest = hn::And(rest, hn::And(hn::Gt(width, zero()), hn::Gt(height, zero())));
  if (hn::AllFalse(di, rest)) return;
  result.drawn += hn::CountTrue(di, rest);
  result.coverage_tests +=
      static_cast<std::uint64_t>(hn::GetLane(hn::SumOfLanes(di, hn::IfThenElseZero(rest, hn::Mul(width, height)))));

  const VI sign = hn::IfThenElse(hn::Gt(area, zero()), number(1), number(-1));
  const VI x = hn::Add(hn::ShiftLeftSame(x0, shift), sample_x), y = hn::Add(hn::ShiftLeftSame(y0, shift), sample_y);
  const std::array<Edge, 3> edges{make_edge(rules, c[1], c[2], sign, x, y), make_edge(rules, c[2], c[0], sign, x, y),
                                  make_edge(rules, c[0], c[1], sign, x, y)};
  M unchecked = rest;
  for (const int size : {2, most_checked}) {
    const VI beyond = number(size + 1);
    const M fits = hn::And(unchecked, hn::And(hn::Lt(width, beyond), hn::Lt(height, beyond)));
    if (hn::AllFalse(di, fits)) continue;
    unchecked = hn::AndNot(fits, unchecked);
    rest = hn::AndNot(hn::AndNot(any_covered(edges, width, height, size), fits), rest);
  }
  if (hn::AllFalse(di, rest)) return;
  result.kept |= bits_of(rest) << first;

  const VI size = hn::Mul(sign, area);
  const V inverse_area = hn::Div(hn::Set(d, 1.0f), hn::ConvertTo(d, size));
  const VI ties = hn::Or(hn::Or(edges[0].owned, hn::ShiftLeft<1>(edges[1].owned)), hn::ShiftLeft<2>(edges[2].owned));
  const VI shape = hn::Or(hn::Or(width, hn::ShiftLeft<8>(height)), hn::ShiftLeft<16>(ties));
  HWY_ALIGN std::array<std::int32_t, 4 * hn::MaxLanes(DI())> numbers[4];
  const auto bits = [&](V v) HWY_ATTR { return hn::BitCast(di, v); };
  hn::StoreInterleaved4(edges[0].value, edges[1].value, size, bits(inverse_area), di, numbers[0].data());
  hn::StoreInterleaved4(edges[0].step_x, edges[1].step_x, edges[0].step_y, edges[1].step_y, di, numbers[1].data());
  hn::StoreInterleaved4(bits(c[0].inverse_z), bits(c[1].inverse_z), bits(c[2].inverse_z), zero(), di,
                        numbers[2].data());
  hn::StoreInterleaved4(hn::Or(x0, hn::ShiftLeft<16>(y0)), shape, zero(), zero(), di, numbers[3].data());
  const hn::FixedTag<std::int32_t, 4> quarter;
  for (std::size_t i = 0; i < hn::Lanes(di); ++i) {
    auto* to = reinterpret_cast<std::int32_t*>(&result.triangles[first + i]);
    for (std::size_t k = 0; k < 4; ++k) hn::Store(hn::Load(quarter, numbers[k].data() + 4 * i), quarter, to + 4 * k);
  }
}

}  // namespace

void assemble_block(const AssemblyRules& rules, const CornerBlock& corners, int count, AssembledBlock& result) {
  const DI di;
  result.kept = result.left = 0;
  result.degenerate = result.back_facing = result.drawn = result.coverage_tests = 0;
  const auto all = static_cast<std::size_t>(count);
  for (std::size_t first = 0; first < all; first += hn::Lanes(di))
    assemble_vector(rules, corners, first, hn::FirstN(di, all - first), result);
}

}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace ps::raster {

AssembleBlock assemble_kernel(Simd simd) {
#if HWY_ARCH_X86
  const std::int64_t have = hwy::SupportedTargets();
  if (may_use(simd, Simd::avx512, have, HWY_AVX3)) return N_AVX3::assemble_block;
  if (may_use(simd, Simd::avx2, have, HWY_AVX2)) return N_AVX2::assemble_block;
  if (may_use(simd, Simd::sse4, have, HWY_SSE4)) return N_SSE4::assemble_block;
#else
  static_cast<void>(simd);
#endif
  return nullptr;
}

}  // namespace ps::raster
#endif
