#include <algorithm>
#include <bit>
#include <cstddef>

#include "options/simd_choice.h"
#include "raster/fast/resolve.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/fast/resolve_kernel.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
#include "hwy/highway.h"

#if HWY_ARCH_X86 && (HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3)
#include "raster/fast/row_writer-inl.h"
#include "raster/fast/sources-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ps::raster::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using namespace resolving;

/// Which triangles the lanes in `seen` show, if they are few; how many, or 0.
HWY_INLINE std::size_t find_few(const Fragments& fragments, M seen, std::array<Share, FewTriangles::most>& few) {
  const D d;
  const DI di;
  const VI ids = hn::Load(di, reinterpret_cast<const std::int32_t*>(fragments.id.data()));
  const std::size_t most = std::min(FewTriangles::most, hn::Lanes(d) / 4);
  std::size_t count = 0;
  for (M rest = seen; !hn::AllFalse(d, rest); ++count) {
    if (count == most) return 0;
    const std::uint32_t id = fragments.id[static_cast<std::size_t>(hn::FindFirstTrue(d, rest))];
    const M mask = hn::RebindMask(d, hn::Eq(ids, hn::Set(di, static_cast<std::int32_t>(id))));
    few[count] = {id, mask};
    rest = hn::AndNot(mask, rest);
  }
  return count;
}

/// The colours of the fragments in `seen`, which are of one surface, as all are that `fragments` names.
HWY_NOINLINE V3 shade_surface(ResolveTask& task, std::uint32_t surface, const Fragments& fragments, M seen) {
  const BatchShading& how = task.rows.surfaces()[surface].shading;
  if (how.source == BatchLight::none && !how.texture.texture) return shading::splat3(how.colour);
  std::array<Share, FewTriangles::most> few;
  const std::size_t count = fragments.in_row ? find_few(fragments, seen, few) : 0;
  if (count > 0)
    return shading::shade_vector(how, FewTriangles(task, how, fragments, std::span(few).first(count)), fragments.z,
                                 seen, task.texels);
  return shading::shade_vector(how, ManyTriangles(task, how, fragments), fragments.z, seen, task.texels);
}

/// Names the triangles that the lanes of `seen` show; `ids` are those in memory at `from`.
HWY_INLINE void name_triangles(VI ids, const std::uint32_t* from, M seen, Fragments& fragments) {
  const DI di;
  const auto some = static_cast<std::int32_t>(from[hn::FindFirstTrue(D(), seen)]);
  hn::Store(hn::IfThenElse(hn::RebindMask(di, seen), ids, hn::Set(di, some)), di,
            reinterpret_cast<std::int32_t*>(fragments.id.data()));
}

/// Calls use(colours, lanes) once for every surface that the lanes of `seen` show.
template <class Use>
HWY_INLINE void shade_by_surface(ResolveTask& task, Fragments& fragments, M seen, Use&& use) {
  if (task.rows.surfaces().size() == 1) {
    use(shade_surface(task, 0, fragments, seen), seen);
    return;
  }
  const D d;
  const DI di;
  HWY_ALIGN std::array<std::int32_t, most_lanes> surface;
  for (std::size_t i = 0; i < hn::Lanes(d); ++i)
    surface[i] = static_cast<std::int32_t>(task.tile.triangles[fragments.id[i]].surface());
  const VI surfaces = hn::Load(di, surface.data());
  HWY_ALIGN const std::array<std::uint32_t, most_lanes> all = fragments.id;
  const VI ids = hn::Load(di, reinterpret_cast<const std::int32_t*>(all.data()));
  for (M rest = seen; !hn::AllFalse(d, rest);) {
    const std::int32_t next = surface[static_cast<std::size_t>(hn::FindFirstTrue(d, rest))];
    const M mask = hn::And(rest, hn::RebindMask(d, hn::Eq(surfaces, hn::Set(di, next))));
    rest = hn::AndNot(mask, rest);
    name_triangles(ids, all.data(), mask, fragments);
    use(shade_surface(task, static_cast<std::uint32_t>(next), fragments, mask), mask);
  }
}

/// Not by Ne(c, c), which is false for NaN on AVX2 and AVX-512.
HWY_INLINE M is_nan(const V3& c) { return hn::Or(hn::Or(hn::IsNaN(c.x), hn::IsNaN(c.y)), hn::IsNaN(c.z)); }

/// Which lanes show triangle `id`, and whether all others show nothing.
struct Alone {
  M seen{};
  bool alone = false;
};
HWY_INLINE Alone alone_in(VI ids, std::uint32_t id) {
  const DI di;
  const auto of_id = hn::Eq(ids, hn::Set(di, static_cast<std::int32_t>(id)));
  const auto none = hn::Eq(ids, hn::Set(di, static_cast<std::int32_t>(TileFragments::none)));
  return {hn::RebindMask(D(), of_id), hn::AllTrue(di, hn::Or(of_id, none))};
}

HWY_INLINE VI load_ids(const TileFragments& tile, std::size_t at) {
  return hn::Load(DI(), reinterpret_cast<const std::int32_t*>(tile.id.data() + at));
}

/// A row's vectors that show one triangle alone.
struct ShadedRun {
  const TileTriangle& triangle;
  std::uint32_t id;
  int row;                 ///< in the picture
  std::size_t begin, end;  ///< columns in the tile
  std::size_t first;       ///< of the row's samples in the tile
};

/// Reads the texture for the run's fragments.
HWY_INLINE void look_up_run(ResolveTask& task, const ShadedRun& run, const BatchShading& how, const float* numbers,
                            texture::Lookups& lookups) {
  const D d;
  RunWeights weights_of_run(run.triangle, task.rect.x0 + static_cast<int>(run.begin), run.row);
  for (std::size_t x = run.begin; x < run.end; x += hn::Lanes(d)) {
    const V z = hn::Div(hn::Set(d, 1.0f), hn::Load(d, task.tile.inverse_z.data() + run.first + x));
    const Weights weights = weights_of_run.next(task.rect.x0 + static_cast<int>(x));
    const M seen = alone_in(load_ids(task.tile, run.first + x), run.id).seen;
    shading::add_lookups(how, OneTriangle(how, numbers, weights, z), z, seen, lookups);
  }
  texture::sample(how.texture, lookups, task.texels);
}
static_assert(texture::Lookups::most == fast_tile);

/// Shades the vectors from `x` on, up to `end`, that show triangle `id` alone; where the next one begins.
HWY_NOINLINE std::size_t shade_run(ResolveTask& task, std::uint32_t id, int row, std::size_t x, std::size_t end,
                                   Vec3f* colours) {
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  const TileTriangle& triangle = task.tile.triangles[id];
  ShadedRun run{triangle, id, row, x, x + lanes, static_cast<std::size_t>(row - task.rect.y0) * fast_tile};
  while (run.end < end && alone_in(load_ids(task.tile, run.first + run.end), id).alone) run.end += lanes;
  const BatchShading& how = task.rows.surfaces()[triangle.surface()].shading;
  const bool textured = how.texture.texture != nullptr, lit = how.source != BatchLight::none;
  const std::uint32_t row_begin = textured || lit ? task.rows.row_of(id) : 0;
  const float* const numbers = task.rows.numbers() + row_begin;
  texture::Lookups lookups;
  if (textured) look_up_run(task, run, how, numbers, lookups);

  const V3 background = shading::splat3(task.background);
  M bad = hn::FirstN(d, 0);
  const auto store = [&](const V3& colour) HWY_ATTR {
    const M seen = alone_in(load_ids(task.tile, run.first + x), id).seen;
    bad = hn::Or(bad, hn::And(is_nan(colour), seen));
    const V3 shown = choose(seen, colour, background);
    hn::StoreInterleaved3(shown.x, shown.y, shown.z, d, &colours[x].x);
  };
  if (lit) {
    RunWeights weights_of_run(triangle, task.rect.x0 + static_cast<int>(x), row);
    for (; x < run.end; x += lanes) {
      const V z = hn::Div(hn::Set(d, 1.0f), hn::Load(d, task.tile.inverse_z.data() + run.first + x));
      const Weights weights = weights_of_run.next(task.rect.x0 + static_cast<int>(x));
      const V3 own = shading::own_colour(how, lookups, (x - run.begin) / lanes);
      store(shading::light_vector(how, OneTriangle(how, numbers, weights, z), own));
    }
  } else {
    for (; x < run.end; x += lanes) store(shading::own_colour(how, lookups, (x - run.begin) / lanes));
  }
  task.nan = task.nan || !hn::AllFalse(d, bad);
  return x;
}

/// Shades a vector that shows several triangles.
HWY_INLINE V3 shade_mixed(ResolveTask& task, VI ids, std::size_t at, std::size_t x, M seen, Fragments& fragments) {
  const D d;
  const DI di;
  V3 colour = shading::splat3(task.background);
  fragments.inverse_z = hn::Load(d, task.tile.inverse_z.data() + at);
  fragments.z = hn::Div(hn::Set(d, 1.0f), fragments.inverse_z);
  hn::Store(hn::Add(hn::Iota(di, 0), hn::Set(di, task.rect.x0 + static_cast<int>(x))), di, fragments.column.data());
  name_triangles(ids, task.tile.id.data() + at, seen, fragments);
  shade_by_surface(task, fragments, seen, [&](const V3& shaded, M mask) HWY_ATTR {
    colour = choose(mask, shaded, colour);
    task.nan = task.nan || !hn::AllFalse(d, hn::And(is_nan(shaded), mask));
  });
  return colour;
}

/// The colours of one row of the tile; whether anything is seen there.
HWY_INLINE bool shade_row(ResolveTask& task, int row, Fragments& fragments, Vec3f* colours) {
  const D d;
  const DI di;
  const V3 background = shading::splat3(task.background);
  const VI none = hn::Set(di, static_cast<std::int32_t>(TileFragments::none));
  const auto wide = static_cast<std::size_t>(task.rect.width());
  bool any = false;
  fragments.row.fill(row);
  for (std::size_t x = 0; x < wide;) {
    const std::size_t at = static_cast<std::size_t>(row - task.rect.y0) * fast_tile + x;
    const VI ids = load_ids(task.tile, at);
    const M seen = hn::RebindMask(d, hn::Ne(ids, none));
    V3 colour = background;
    if (const std::intptr_t lane = hn::FindFirstTrue(d, seen); lane >= 0) {
      any = true;
      const std::uint32_t id = task.tile.id[at + static_cast<std::size_t>(lane)];
      if (alone_in(ids, id).alone) {
        x = shade_run(task, id, row, x, wide, colours);
        continue;
      }
      colour = shade_mixed(task, ids, at, x, seen, fragments);
    }
    hn::StoreInterleaved3(colour.x, colour.y, colour.z, d, &colours[x].x);
    x += hn::Lanes(d);
  }
  return any;
}

}  // namespace

void resolve(ResolveTask& task) {
  RowWriter writer(task.rect, task.output);
  HWY_ALIGN std::array<Vec3f, fast_tile> colours;
  Fragments fragments;
  bool blank = false;
  for (int row = task.rect.y0; row < task.rect.y1; ++row) {
    const bool seen = shade_row(task, row, fragments, colours.data());
    if (seen || !blank) writer.set(colours.data());
    blank = !seen;
    writer.write(row);
  }
  writer.end();
}

void fill(const TileRect& rect, const TileOutput& output, const Vec3f& colour) {
  HWY_ALIGN std::array<Vec3f, fast_tile> colours;
  colours.fill(colour);
  RowWriter writer(rect, output);
  writer.set(colours.data());
  for (int row = rect.y0; row < rect.y1; ++row) writer.write(row);
  writer.end();
}

void count_texels(ResolveTask& task) {
  const D d;
  const std::size_t lanes = hn::Lanes(d);
  Fragments fragments;
  fragments.in_row = false;
  HWY_ALIGN std::array<float, most_lanes> inverse_z{};
  std::size_t count = 0;
  const auto flush = [&]() HWY_ATTR {
    if (count == 0) return;
    fragments.inverse_z = hn::Load(d, inverse_z.data());
    fragments.z = hn::Div(hn::Set(d, 1.0f), fragments.inverse_z);
    std::fill(fragments.id.begin() + static_cast<std::ptrdiff_t>(count), fragments.id.end(), fragments.id[0]);
    shade_by_surface(task, fragments, hn::FirstN(d, count), [](const V3&, M) HWY_ATTR {});
    count = 0;
  };
  for (const ReplacedFragment& fragment : task.tile.replaced) {
    if (!task.rows.surfaces()[task.tile.triangles[fragment.id].surface()].textured) continue;
    fragments.id[count] = fragment.id;
    fragments.column[count] = task.rect.x0 + static_cast<std::int32_t>(fragment.at % fast_tile);
    fragments.row[count] = task.rect.y0 + static_cast<std::int32_t>(fragment.at / fast_tile);
    inverse_z[count] = fragment.inverse_z;
    if (++count == lanes) flush();
  }
  flush();
}

constexpr ResolveKernels all_resolve_kernels{resolve, fill, count_texels};

}  // namespace ps::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if HWY_ONCE
namespace ps::raster {

ResolveKernels resolve_kernels(Simd simd) { return PS_CHOSEN_KERNEL(ResolveKernels, simd, all_resolve_kernels); }

}  // namespace ps::raster
#endif
