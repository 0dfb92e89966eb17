#include <algorithm>
#include <cstddef>

#include "math/unit.h"
#include "options/simd_choice.h"
#include "raster/fast/assembly.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fast/assembly_kernel.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
#include "math/mask_bits-inl.h"
#include "math/quarters-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<float>;
using DI = hn::Rebind<std::int32_t, D>;
using V = hn::Vec<D>;
using VI = hn::Vec<DI>;
using M = hn::Mask<DI>;

constexpr std::size_t most_lanes = hn::MaxLanes(DI());

struct Corner {
  V x, y, z, inverse_z;
  VI column, row, outside;
};

struct Edge {
  VI value, step_x, step_y, owned;  ///< value at the box's first sample; owned is 1 where ties belong to the edge
};

HWY_INLINE VI number(std::int32_t value) { return hn::Set(DI(), value); }
HWY_INLINE VI zero() { return hn::Zero(DI()); }
/// The bits of VertexPlace::outside that are planes.
HWY_INLINE VI planes() { return number(static_cast<std::int32_t>(VertexPlace::no_place - 1)); }

/// The vertices of the triangles from number `first` on, one array for each vertex; lanes beyond the last get the last.
using Vertices = std::array<std::uint32_t, most_lanes>;
HWY_INLINE std::array<Vertices, 3> vertices_of(const AssemblyBlock& block, std::size_t first) {
  const auto all = static_cast<std::size_t>(block.count);
  std::array<Vertices, 3> vertices;
  const auto take = [&](std::size_t lane, std::size_t from) HWY_ATTR {
    for (std::size_t k = 0; k < 3; ++k) vertices[k][lane] = block.corners[from][k];
  };
  if (first + most_lanes <= all) {
    for (std::size_t lane = 0; lane < most_lanes; ++lane) take(lane, first + lane);
  } else {
    for (std::size_t lane = 0; lane < most_lanes; ++lane) take(lane, std::min(first + lane, all - 1));
  }
  return vertices;
}

/// Vertices without their places on the canvas.
HWY_INLINE Corner load_points(const AssemblyBlock& block, const Vertices& vertices) {
  const hn::FixedTag<float, 4> four;
  const auto point = ps::HWY_NAMESPACE::four_vectors(
      [&](std::size_t lane) HWY_ATTR { return hn::LoadU(four, &block.points[vertices[lane]].x); });
  return {point.first, point.second, point.third, point.fourth, zero(), zero(), zero()};
}

HWY_INLINE void load_places(const AssemblyRules& rules, const AssemblyBlock& block, const Vertices& vertices,
                            Corner& corner) {
  const hn::FixedTag<float, 4> four;
  const hn::Rebind<std::int32_t, decltype(four)> four_numbers;
  const DI di;
  const auto place = ps::HWY_NAMESPACE::four_vectors([&](std::size_t lane) HWY_ATTR {
    return hn::BitCast(four, hn::LoadU(four_numbers, &block.places[vertices[lane]].column));
  });
  corner.column = hn::ShiftRightSame(hn::BitCast(di, place.first), rules.spare_bits);
  corner.row = hn::ShiftRightSame(hn::BitCast(di, place.second), rules.spare_bits);
  corner.outside = hn::BitCast(di, place.third);
}

HWY_INLINE V dot(V ax, V ay, V az, V bx, V by, V bz) {
  return hn::Add(hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by)), hn::Mul(az, bz));
}

/// The square of the triangle's normal in camera space keeps its digits, else the clear path knows; and the normal
/// looks towards the eye.
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
  const V square = dot(nx, ny, nz, nx, ny, nz);
  using Squares = ExactSquares<float>;
  return {hn::RebindMask(
              DI(), hn::And(hn::Gt(square, hn::Set(d, Squares::least)), hn::Lt(square, hn::Set(d, Squares::greatest)))),
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
  const VI unit = number(std::int32_t{1} << rules.unit_bits);
  Edge edge;
  edge.value = hn::Sub(hn::Mul(dx, hn::Sub(y, a.row)), hn::Mul(dy, hn::Sub(x, a.column)));
  edge.step_x = hn::Neg(hn::Mul(dy, unit));
  edge.step_y = hn::Mul(dx, unit);
  edge.owned = owned(rules.fill_rule, dx, dy);
  return edge;
}

HWY_INLINE std::uint64_t bits_of(M mask) { return ps::HWY_NAMESPACE::bits_of(DI(), mask); }

/// Which of the triangles in `wanted`, whose boxes have at most tiny_side x tiny_side samples, cover any.
HWY_INLINE M cover_some(const std::array<Edge, 3>& edges, VI width, VI height, M wanted) {
  const DI di;
  const auto most = [&](VI sizes)
                        HWY_ATTR { return hn::GetLane(hn::MaxOfLanes(di, hn::IfThenElseZero(wanted, sizes))); };
  const std::int32_t columns = most(width), rows = most(height);
  std::array<VI, 3> row{edges[0].value, edges[1].value, edges[2].value};
  const std::array<VI, 3> above{hn::Neg(edges[0].owned), hn::Neg(edges[1].owned), hn::Neg(edges[2].owned)};
  M some = hn::MaskFromVec(zero());
  for (int y = 0; y < rows; ++y) {
    const M in_row = hn::Gt(height, number(y));
    std::array<VI, 3> value = row;
    for (int x = 0; x < columns; ++x) {
      const M inside = hn::And(hn::And(hn::Gt(value[0], above[0]), hn::Gt(value[1], above[1])),
                               hn::And(hn::Gt(value[2], above[2]), hn::And(in_row, hn::Gt(width, number(x)))));
      some = hn::Or(some, inside);
      for (std::size_t i = 0; i < 3; ++i) value[i] = hn::Add(value[i], edges[i].step_x);
    }
    for (std::size_t i = 0; i < 3; ++i) row[i] = hn::Add(row[i], edges[i].step_y);
  }
  return hn::And(some, wanted);
}

/// The surfaces of the triangles from number `first` on.
HWY_INLINE VI surfaces_of(const AssemblyBlock& block, std::size_t first) {
  HWY_ALIGN std::int32_t surfaces[most_lanes];
  const auto last = static_cast<std::size_t>(block.count) - 1;
  for (std::size_t i = 0; i < most_lanes; ++i)
    surfaces[i] = static_cast<std::int32_t>(block.surface(std::min(first + i, last)));
  return hn::Load(DI(), surfaces);
}

HWY_INLINE VI lowest(const VI& a, const VI& b, const VI& c) { return hn::Min(hn::Min(a, b), c); }
HWY_INLINE VI highest(const VI& a, const VI& b, const VI& c) { return hn::Max(hn::Max(a, b), c); }

HWY_INLINE void assemble_vector(const AssemblyRules& rules, const AssemblyBlock& block, std::size_t first, M wanted,
                                AssembledBlock& result) {
  const D d;
  const DI di;
  const std::array<Vertices, 3> vertices = vertices_of(block, first);
  std::array<Corner, 3> c{load_points(block, vertices[0]), load_points(block, vertices[1]),
                          load_points(block, vertices[2])};
  const Facing face = facing(c, rules.handedness);
  result.left |= bits_of(hn::AndNot(face.solid, wanted)) << first;
  M rest = hn::And(wanted, face.solid);
  if (rules.cull_backs) {
    result.back_facing += hn::CountTrue(di, hn::AndNot(face.front, rest));
    rest = hn::And(rest, face.front);
  }
  // Of back faces, which mostly come in rows, nothing more is read.
  if (hn::AllFalse(di, rest)) return;
  for (std::size_t k = 0; k < 3; ++k) load_places(rules, block, vertices[k], c[k]);
  // Clipping goes from plane to plane. Where the first that any vertex is behind has all of them behind it, it leaves
  // nothing, and those before it cut nothing.
  const VI any_behind = hn::Or(hn::Or(c[0].outside, c[1].outside), c[2].outside);
  const VI all_behind = hn::And(hn::And(c[0].outside, c[1].outside), c[2].outside);
  const VI first_plane = hn::And(hn::And(any_behind, hn::Neg(any_behind)), planes());
  const M gone = hn::And(rest, hn::Ne(hn::And(first_plane, all_behind), zero()));
  result.clipped_away += hn::CountTrue(di, gone);
  rest = hn::AndNot(gone, rest);
  const VI low_x = lowest(c[0].column, c[1].column, c[2].column), low_y = lowest(c[0].row, c[1].row, c[2].row);
  const VI high_x = highest(c[0].column, c[1].column, c[2].column), high_y = highest(c[0].row, c[1].row, c[2].row);
  const M whole = hn::Eq(any_behind, zero());
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
  const int shift = rules.unit_bits;
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
  const VI size = hn::Mul(sign, area);
  const V inverse_area = hn::Div(hn::Set(d, 1.0f), hn::ConvertTo(d, size));
  const VI beyond = number(tiny_side + 1);
  const M tiny = hn::And(rest, hn::And(hn::Lt(width, beyond), hn::Lt(height, beyond)));
  if (!hn::AllFalse(di, tiny)) rest = hn::Or(hn::AndNot(tiny, rest), cover_some(edges, width, height, tiny));
  if (hn::AllFalse(di, rest)) return;
  result.kept |= bits_of(rest) << first;

  const VI ties = hn::Or(hn::Or(edges[0].owned, hn::ShiftLeft<1>(edges[1].owned)), hn::ShiftLeft<2>(edges[2].owned));
  const VI shape = hn::Or(hn::Or(width, hn::ShiftLeft<8>(height)), hn::ShiftLeft<16>(ties));
  HWY_ALIGN std::array<std::int32_t, 4 * hn::MaxLanes(DI())> numbers[4];
  const auto bits = [&](V v) HWY_ATTR { return hn::BitCast(di, v); };
  hn::StoreInterleaved4(edges[0].value, edges[1].value, size, bits(inverse_area), di, numbers[0].data());
  hn::StoreInterleaved4(edges[0].step_x, edges[1].step_x, edges[0].step_y, edges[1].step_y, di, numbers[1].data());
  VI surfaces = number(static_cast<std::int32_t>(block.first_surface));
  if (block.triangles) surfaces = surfaces_of(block, first);
  hn::StoreInterleaved4(bits(c[0].inverse_z), bits(c[1].inverse_z), bits(c[2].inverse_z), surfaces, di,
                        numbers[2].data());
  hn::StoreInterleaved4(hn::Or(x0, hn::ShiftLeft<16>(y0)), shape, number(static_cast<std::int32_t>(block.object)),
                        hn::Iota(di, static_cast<std::int32_t>(block.first + first)), di, numbers[3].data());
  const hn::FixedTag<std::int32_t, 4> quarter;
  for (std::uint64_t lanes = bits_of(rest); lanes != 0; lanes &= lanes - 1) {
    const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero64(lanes);
    auto* to = reinterpret_cast<std::int32_t*>(result.triangles++);
    for (std::size_t k = 0; k < 4; ++k) hn::Store(hn::Load(quarter, numbers[k].data() + 4 * i), quarter, to + 4 * k);
  }
}
static_assert(offsetof(FastTriangle, surface) == 44 && offsetof(FastTriangle, object) == 56);

}  // namespace

void assemble_block(const AssemblyRules& rules, const AssemblyBlock& block, AssembledBlock& result) {
  const DI di;
  result.kept = result.left = 0;
  result.degenerate = result.back_facing = result.clipped_away = result.drawn = result.coverage_tests = 0;
  const auto all = static_cast<std::size_t>(block.count);
  for (std::size_t first = 0; first < all; first += hn::Lanes(di))
    assemble_vector(rules, block, first, hn::FirstN(di, all - first), result);
}

}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace ps::raster {

AssembleBlock assemble_kernel(Simd simd) { return PS_CHOSEN_KERNEL(AssembleBlock, simd, assemble_block); }

}  // namespace ps::raster
#endif
