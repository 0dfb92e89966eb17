#include "raster/fast/scan_triangle.h"

#include <algorithm>

#include "options/simd_choice.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fast/scan_triangle_kernel.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Edge values as 32-bit integers, for triangles of up to about 60 pixels.
struct Small {
  using D = hn::ScalableTag<float>;
  using Count = hn::Rebind<std::int32_t, D>;
  using Scalar = std::int32_t;
  using Value = hn::Vec<Count>;
  static HWY_INLINE Value ramp() { return hn::Iota(Count(), 0); }
  static HWY_INLINE hn::Mask<D> above(Value value, Value threshold) {
    return hn::RebindMask(D(), hn::Gt(value, threshold));
  }
  static HWY_INLINE hn::Vec<D> to_float(Value value) { return hn::ConvertTo(D(), value); }
};

/// Edge values as doubles, which hold integers below 2^53 exactly and round once on their way to float, as a 64-bit
/// integer does.
struct Large {
  using Count = hn::ScalableTag<double>;
  using D = hn::Rebind<float, Count>;
  using Scalar = double;
  using Value = hn::Vec<Count>;
  static HWY_INLINE Value ramp() { return hn::Iota(Count(), 0); }
  static HWY_INLINE hn::Mask<D> above(Value value, Value threshold) {
    const Value flag = hn::IfThenElseZero(hn::Gt(value, threshold), hn::Set(Count(), 1.0));
    return hn::Gt(hn::DemoteTo(D(), flag), hn::Zero(D()));
  }
  static HWY_INLINE hn::Vec<D> to_float(Value value) { return hn::DemoteTo(D(), value); }
};

/// Whole vectors from fragment number `at` on; the next ones overwrite what is too much.
template <class Kind, class V, class Pixels>
HWY_INLINE void append(V weight0, V weight1, V weight2, V z, Pixels pixels, ShadeBatch& batch, std::size_t at) {
  const typename Kind::D d;
  hn::StoreU(weight0, d, batch.weights[0].data() + at);
  hn::StoreU(weight1, d, batch.weights[1].data() + at);
  hn::StoreU(weight2, d, batch.weights[2].data() + at);
  hn::StoreU(z, d, batch.z.data() + at);
  hn::StoreU(pixels, hn::Rebind<std::int32_t, typename Kind::D>(), batch.pixels.data() + at);
}

template <class Kind>
HWY_INLINE int scan_rows(const TriangleScan& scan, int row, ShadeBatch& batch, ScanCounts& counts) {
  using Scalar = typename Kind::Scalar;
  using Value = typename Kind::Value;
  using V = hn::Vec<typename Kind::D>;
  using M = hn::Mask<typename Kind::D>;
  const typename Kind::D d;
  const typename Kind::Count dc;
  const hn::Rebind<std::int32_t, typename Kind::D> di;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const EdgeFunctions& edges = *scan.edges;
  const int width = scan.box.x1 - scan.box.x0;
  const auto spread = [&](std::size_t i)
                          HWY_ATTR { return hn::Mul(Kind::ramp(), hn::Set(dc, static_cast<Scalar>(edges.step_x[i]))); };
  const Value spread0 = spread(0), spread1 = spread(1), spread2 = spread(2);
  const Value threshold0 = hn::Set(dc, static_cast<Scalar>(edges.threshold[0]));
  const Value threshold1 = hn::Set(dc, static_cast<Scalar>(edges.threshold[1]));
  const Value threshold2 = hn::Set(dc, static_cast<Scalar>(edges.threshold[2]));
  const V inverse_area = hn::Set(d, scan.inverse_area);
  const V inverse_z0 = hn::Set(d, scan.inverse_z[0]), inverse_z1 = hn::Set(d, scan.inverse_z[1]),
          inverse_z2 = hn::Set(d, scan.inverse_z[2]);
  const V one = hn::Set(d, 1.0f);
  const bool farther_wins = scan.depth_value == DepthValue::inverse_z;
  for (; row < scan.box.y1; ++row) {
    if (batch.count + width + lanes > ShadeBatch::capacity) return row;
    const auto start = edges.at(scan.box.x0, row);
    float* depth_row = scan.depth ? scan.depth + (row - scan.box.y0) * scan.depth_stride : nullptr;
    const int first_pixel = row * scan.frame_width + scan.box.x0;
    for (int x = 0; x < width; x += lanes) {
      const auto value = [&](std::size_t i, Value spread_i) HWY_ATTR {
        return hn::Add(hn::Set(dc, static_cast<Scalar>(start[i] + edges.step_x[i] * x)), spread_i);
      };
      const Value value0 = value(0, spread0), value1 = value(1, spread1), value2 = value(2, spread2);
      M inside = hn::And(hn::And(Kind::above(value0, threshold0), Kind::above(value1, threshold1)),
                         hn::And(Kind::above(value2, threshold2), hn::FirstN(d, static_cast<std::size_t>(width - x))));
      if (hn::AllFalse(d, inside)) continue;
      counts.fragments += hn::CountTrue(d, inside);
      const V weight0 = hn::Mul(Kind::to_float(value0), inverse_area);
      const V weight1 = hn::Mul(Kind::to_float(value1), inverse_area);
      const V weight2 = hn::Mul(Kind::to_float(value2), inverse_area);
      const V inverse_z =
          hn::Add(hn::Add(hn::Mul(weight0, inverse_z0), hn::Mul(weight1, inverse_z1)), hn::Mul(weight2, inverse_z2));
      if (depth_row) {
        V depth = inverse_z;
        if (!farther_wins)
          depth = hn::Add(hn::Add(hn::Mul(weight0, hn::Set(d, scan.stored_depth[0])),
                                  hn::Mul(weight1, hn::Set(d, scan.stored_depth[1]))),
                          hn::Mul(weight2, hn::Set(d, scan.stored_depth[2])));
        const V stored = hn::LoadU(d, depth_row + x);
        const M nearer = farther_wins ? hn::Gt(depth, stored) : hn::Lt(depth, stored);
        const M passed = hn::And(inside, nearer);
        counts.depth_failures += hn::CountTrue(d, hn::AndNot(nearer, inside));
        if (hn::AllFalse(d, passed)) continue;
        hn::StoreU(hn::IfThenElse(passed, depth, stored), d, depth_row + x);
        inside = passed;
      }
      const auto at = static_cast<std::size_t>(batch.count);
      const V z = hn::Div(one, inverse_z);
      const auto pixels = hn::Add(hn::Iota(di, 0), hn::Set(di, first_pixel + x));
      if (hn::AllTrue(d, inside)) {
        append<Kind>(weight0, weight1, weight2, z, pixels, batch, at);
        batch.count += lanes;
      } else {
        // Not CompressStore: some processors store lane by lane there.
        append<Kind>(hn::Compress(weight0, inside), hn::Compress(weight1, inside), hn::Compress(weight2, inside),
                     hn::Compress(z, inside), hn::Compress(pixels, hn::RebindMask(di, inside)), batch, at);
        batch.count += static_cast<int>(hn::CountTrue(d, inside));
      }
    }
  }
  return row;
}

}  // namespace

int scan_triangle(const TriangleScan& scan, int row, ShadeBatch& batch, ScanCounts& counts);

int scan_triangle(const TriangleScan& scan, int row, ShadeBatch& batch, ScanCounts& counts) {
  // The largest value over the box, and one vector beyond it, which is computed and thrown away.
  std::int64_t largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto magnitude = [](std::int64_t v) { return v < 0 ? -v : v; };
    const std::int64_t reach = (scan.box.x1 - scan.box.x0 + 16) * magnitude(scan.edges->step_x[i]) +
                               (scan.box.y1 - scan.box.y0) * magnitude(scan.edges->step_y[i]);
    largest = std::max(largest, magnitude(scan.edges->at(scan.box.x0, scan.box.y0)[i]) + reach);
  }
  if (largest < (std::int64_t{1} << 31)) return scan_rows<Small>(scan, row, batch, counts);
  return scan_rows<Large>(scan, row, batch, counts);
}

}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace ps::raster {

bool can_scan(const TriangleScan& scan) {
  const bool interpolated = scan.depth_value == DepthValue::inverse_z || scan.depth_value == DepthValue::z;
  if (!interpolated && scan.depth) return false;
  const auto far = [](std::int64_t v) { return v > (std::int64_t{1} << 43) || v < -(std::int64_t{1} << 43); };
  const auto value = scan.edges->at(scan.box.x0, scan.box.y0);
  for (std::size_t i = 0; i < 3; ++i) {
    if (value[i] > (std::int64_t{1} << 51) || value[i] < -(std::int64_t{1} << 51)) return false;
    if (far(scan.edges->step_x[i]) || far(scan.edges->step_y[i])) return false;
  }
  return true;
}

ScanTriangle scan_function(Simd simd) { return PS_CHOSEN_KERNEL(ScanTriangle, simd, scan_triangle); }

}  // namespace ps::raster
#endif
