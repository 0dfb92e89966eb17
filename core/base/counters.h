#pragma once
#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>

#include "base/check.h"

namespace ps {

/// Work that the renderers count. Counts never depend on the number of threads.
enum class Counter {
  eye_rays,
  shadow_rays,
  reflection_rays,
  refraction_rays,
  sphere_tests,
  triangle_tests,
  solid_tests,  ///< planes, rectangles, boxes, cylinders and CSG objects
  node_visits,
  edge_rays,  ///< hits by Embree that our own test places outside the triangle, by rounding
  shading_calls,
  light_samples,
  texel_reads,
  triangles_in,    ///< triangles that entered the rasterizer, after tessellation
  objects_culled,  ///< instances dropped whole by their bounding sphere
  triangles_backfacing,
  triangles_clipped_away,  ///< wholly outside one clipping plane
  triangles_split,         ///< cut by a clipping plane
  triangles_degenerate,    ///< zero area, never drawn
  triangles_drawn,         ///< after clipping, sent to coverage
  coverage_tests,          ///< sample positions tested one by one
  coverage_regions,        ///< rows, cells or pieces of triangles that coverage decided or cut as a whole
  fragments,               ///< covered samples; with multisampling, pixels with a covered sample
  subsamples,              ///< covered samples, with multisampling
  depth_tests,
  depth_failures,
  attributes_interpolated,  ///< single scalars interpolated across a triangle
  pixels_written,
  lines_drawn,
  pixels_subdivided,  ///< got more samples because neighbours differed
  searches_saved,     ///< eye rays that met the object of the pixels around without a search
  nan_pixels,
  shadow_map_taps,   ///< texels of shadow maps compared with a depth
  silhouette_edges,  ///< from which the sides of shadow volumes start
  stencil_tests,     ///< covered samples of shadow volumes
  stencil_updates,   ///< those that changed a count
  environment_reads,
  octree_entries,  ///< primitives that the leaves of an octree list: one that touches several is in each
  count_
};

inline constexpr std::size_t counter_count = static_cast<std::size_t>(Counter::count_);

/// Key for files ("shadow-rays") and label for people ("shadow rays").
std::string_view counter_key(Counter counter);
std::string_view counter_label(Counter counter);

class CounterSet {
 public:
  constexpr CounterSet() = default;
  constexpr CounterSet(std::initializer_list<Counter> members) {
    for (const Counter member : members) insert(member);
  }
  static constexpr CounterSet all() {
    CounterSet set;
    set.bits_ = ~std::uint64_t{0};
    return set;
  }
  constexpr void insert(Counter counter) { bits_ |= bit(counter); }
  constexpr bool contains(Counter counter) const { return (bits_ & bit(counter)) != 0; }
  bool operator==(const CounterSet&) const = default;

 private:
  static_assert(counter_count <= 64);
  static constexpr std::uint64_t bit(Counter counter) { return std::uint64_t{1} << static_cast<unsigned>(counter); }
  std::uint64_t bits_ = 0;
};

/// One number for each Counter that a renderer gives. A counter that it cannot give is absent, which is not 0.
/// Kernels add to any of them; the facade (render/render.h) then takes what the renderer's row declares.
struct Counters {
  std::array<std::uint64_t, counter_count> values{};
  CounterSet given = CounterSet::all();

  /// The count; nullopt if the renderer cannot give it.
  std::optional<std::uint64_t> get(Counter c) const {
    if (!given.contains(c)) return {};
    return values[static_cast<std::size_t>(c)];
  }
  /// For kernels, which write.
  std::uint64_t& operator[](Counter c) { return values[static_cast<std::size_t>(c)]; }
  /// For those who know that the renderer gives it.
  std::uint64_t operator[](Counter c) const {
    PS_ASSERT(given.contains(c), "a counter that the renderer gives");
    return values[static_cast<std::size_t>(c)];
  }
  Counters& operator+=(const Counters& other) {
    for (std::size_t i = 0; i < counter_count; ++i) values[i] += other.values[i];
    return *this;
  }
  bool operator==(const Counters&) const = default;
};

/// The sum of those of `summands` that are given; nullopt if none is.
std::optional<std::uint64_t> counted_sum(const Counters& counters, std::initializer_list<Counter> summands);

}  // namespace ps
