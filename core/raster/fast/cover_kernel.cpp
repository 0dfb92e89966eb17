#include <algorithm>
#include <limits>

#include "frame/region.h"
#include "options/simd_choice.h"
#include "raster/fast/tile.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fast/cover_kernel.cpp"
#include "hwy/cache_control.h"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
#include "raster/fast/cover_box-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using namespace covering;

/// Without vectors: edges whose values double may not hold.
template <Replaced replaced>
std::uint64_t cover_exactly(const BoxEdges<std::int64_t>& edges, std::uint32_t id, TileFragments& tile) {
  std::uint64_t passes = 0;
  for (int y = 0; y < edges.height; ++y)
    for (int x = 0; x < edges.width; ++x) {
      std::array<float, 3> weights;
      bool inside = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::int64_t value = edges.value[i] + edges.step_x[i] * x + edges.step_y[i] * y;
        inside = inside && value > edges.threshold[i];
        weights[i] = static_cast<float>(value) * edges.inverse_area;
      }
      if (!inside) continue;
      ++tile.fragments;
      const float inverse_z =
          weights[0] * edges.inverse_z[0] + weights[1] * edges.inverse_z[1] + weights[2] * edges.inverse_z[2];
      const std::size_t at = static_cast<std::size_t>(edges.y + y) * fast_tile + static_cast<std::size_t>(edges.x + x);
      if (!(inverse_z > tile.inverse_z[at])) continue;
      ++passes;
      if constexpr (replaced == Replaced::kept) keep_replaced(tile, at, 1, tile.replaced);
      tile.inverse_z[at] = inverse_z;
      tile.id[at] = id;
    }
  return passes;
}

template <class Scalar>
void place(const TileRect& box, const TileRect& rect, BoxEdges<Scalar>& edges) {
  edges.x = box.x0 - rect.x0;
  edges.y = box.y0 - rect.y0;
  edges.width = box.x1 - box.x0;
  edges.height = box.y1 - box.y0;
}

template <Replaced replaced>
HWY_INLINE std::uint64_t cover_small(const FastTriangle& triangle, const TileRect& rect, std::uint32_t id,
                                     TileFragments& tile) {
  const TileRect whole = triangle.box();
  const TileRect box = common_part(whole, rect);
  const std::int32_t dx = box.x0 - whole.x0, dy = box.y0 - whole.y0;
  BoxEdges<std::int32_t> edges;
  place(box, rect, edges);
  edges.inverse_area = triangle.inverse_area;
  edges.inverse_z = triangle.inverse_z.data();
  for (std::size_t i = 0; i < 2; ++i) {
    edges.step_x[i] = triangle.step_x[i];
    edges.step_y[i] = triangle.step_y[i];
    edges.value[i] = triangle.value[i] + dx * triangle.step_x[i] + dy * triangle.step_y[i];
  }
  edges.step_x[2] = -triangle.step_x[0] - triangle.step_x[1];
  edges.step_y[2] = -triangle.step_y[0] - triangle.step_y[1];
  edges.value[2] = triangle.area - edges.value[0] - edges.value[1];
  for (std::size_t i = 0; i < 3; ++i) edges.threshold[i] = -static_cast<std::int32_t>(triangle.shape >> (16 + i) & 1);
  constexpr int narrow = 2 * static_cast<int>(hn::MaxLanes(D()));
  const int offset = edges.x & (static_cast<int>(hn::Lanes(D())) - 1);
  if (offset + edges.width <= narrow) return cover_narrow_box<replaced>(edges, id, tile);
  return cover_box<Small, Covers::some, replaced>(edges, id, tile);
}

template <Replaced replaced>
std::uint64_t cover_large(const LargeTriangle& triangle, const TileRect& whole, const std::array<float, 3>& inverse_z,
                          const TileRect& rect, std::uint32_t id, TileFragments& tile) {
  const TileRect box = common_part(whole, rect);
  BoxEdges<std::int64_t> edges;
  place(box, rect, edges);
  edges.inverse_area = triangle.inverse_area;
  edges.inverse_z = inverse_z.data();
  edges.value = triangle.edges.at(box.x0, box.y0);
  edges.step_x = triangle.edges.step_x;
  edges.step_y = triangle.edges.step_y;
  edges.threshold = triangle.edges.threshold;
  const BoxLies lies = place_of_box(edges);
  if (lies == BoxLies::outside) return 0;
  if (!triangle.fits_double) return cover_exactly<replaced>(edges, id, tile);
  BoxEdges<double> wide;
  place(box, rect, wide);
  wide.inverse_area = edges.inverse_area;
  wide.inverse_z = edges.inverse_z;
  for (std::size_t i = 0; i < 3; ++i) {
    wide.value[i] = static_cast<double>(edges.value[i]);
    wide.step_x[i] = static_cast<double>(edges.step_x[i]);
    wide.step_y[i] = static_cast<double>(edges.step_y[i]);
    wide.threshold[i] = static_cast<double>(edges.threshold[i]);
  }
  const bool at_vector = edges.x % static_cast<int>(hn::Lanes(D())) == 0;
  if (at_vector && lies == BoxLies::inside) return cover_box<Large, Covers::all, replaced>(wide, id, tile);
  return cover_box<Large, Covers::some, replaced>(wide, id, tile);
}

template <Replaced replaced>
void cover_entries(const TileRect& rect, const FastPart& part, std::span<const std::uint32_t> entries,
                   TileFragments& tile) {
  constexpr std::size_t ahead = 16;
  const FastTriangle* const triangles = part.triangles.data();
  TileTriangle* const seen = tile.triangles.data();
  std::uint64_t* const passed_of = tile.passed.data();
  std::uint32_t id = tile.triangle_count;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i + ahead < entries.size()) hwy::Prefetch(&triangles[entries[i + ahead]]);
    const FastTriangle& triangle = triangles[entries[i]];
    const std::uint64_t passed =
        triangle.is_general()
            ? cover_large<replaced>(part.large[triangle.triangle], part.cut.triangles[triangle.triangle].box,
                                    triangle.inverse_z, rect, id, tile)
            : cover_small<replaced>(triangle, rect, id, tile);
    passed_of[triangle.surface] += passed;
    seen[id] = {&triangle, &part};
    id += passed > 0 ? 1 : 0;
  }
  tile.triangle_count = id;
}

}  // namespace

void cover(const TileRect& rect, const FastPart& part, std::span<const std::uint32_t> entries, TileFragments& tile) {
  if (tile.keep_replaced)
    cover_entries<Replaced::kept>(rect, part, entries, tile);
  else
    cover_entries<Replaced::forgotten>(rect, part, entries, tile);
}

}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace ps::raster {

void TileFragments::start(std::size_t entries, std::size_t surfaces) {
  inverse_z.fill(-std::numeric_limits<float>::infinity());
  id.fill(none);
  if (triangles.size() < entries + 1) triangles.resize(entries + 1 + entries / 2);
  triangle_count = 0;
  fragments = 0;
  passed.assign(surfaces, 0);
  replaced.clear();
}

CoverTile cover_kernel(Simd simd) { return PS_CHOSEN_KERNEL(CoverTile, simd, cover); }

}  // namespace ps::raster
#endif
