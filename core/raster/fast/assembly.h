#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "raster/assembly/assemble.h"
#include "raster/base/vertex_buffer.h"

namespace ps::raster {

/// A triangle ready for coverage, in one cache line. Small ones, which nothing cuts, carry their edges (EdgeFunctions)
/// as 32-bit integers, in units of AssemblyRules; what edge 2 has follows from the others, since the three values add
/// up to the area.
struct FastTriangle {
  static constexpr std::uint32_t general = 1u << 31;  ///< in `shape`: number `triangle` of FastPart::cut instead

  std::array<std::int32_t, 2> value{};  ///< of edges 0 and 1 at the box's first sample
  std::int32_t area = 0;
  float inverse_area = 0;
  std::array<std::int32_t, 2> step_x{}, step_y{};
  std::array<float, 3> inverse_z{};
  std::uint32_t surface = 0;   ///< index into RasterInputs::surfaces
  std::uint32_t corner = 0;    ///< of the box: column, and from bit 16 on row
  std::uint32_t shape = 0;     ///< of the box: columns, from bit 8 on rows; from bit 16 on which edges own their ties
  std::uint32_t object = 0;    ///< index into RasterInputs::objects
  std::uint32_t triangle = 0;  ///< of the object's mesh

  bool is_general() const { return (shape & general) != 0; }
  TileRect box() const {
    const auto x = static_cast<int>(corner & 0xffff), y = static_cast<int>(corner >> 16);
    return {x, y, x + static_cast<int>(shape & 0xff), y + static_cast<int>(shape >> 8 & 0xff)};
  }
};
static_assert(sizeof(FastTriangle) == 64);

/// The edges of a piece of FastPart::cut.
struct LargeTriangle {
  EdgeFunctions edges;
  float inverse_area = 0;
  bool fits_double = false;  ///< whether double holds the values in its box and up to a vector around it exactly
};

/// A few triangles that follow each other in their object's mesh, and its vertices.
struct AssemblyBlock {
  static constexpr int capacity = 64;
  const std::array<std::uint32_t, 3>* corners = nullptr;  ///< indices of vertices
  const MeshTriangle* triangles = nullptr;                ///< the same, where their materials differ
  int count = 0;
  const Vec4f* points = nullptr;
  const VertexPlace* places = nullptr;
  std::uint32_t object = 0;         ///< index into RasterInputs::objects
  std::uint32_t first_surface = 0;  ///< of the object, index into RasterInputs::surfaces
  std::uint32_t first = 0;          ///< number of the first triangle in the mesh

  std::uint32_t surface(std::size_t i) const { return first_surface + (triangles ? triangles[i].material : 0); }
};

/// What is the same for all triangles of an object. Lengths are in units of 2^-unit_bits pixels: those of FixedPoint,
/// or twice as long where vertices and samples are even. Edge values and area are then a quarter as large, and their
/// quotients the same to the last bit.
struct AssemblyRules {
  float handedness = 1;
  bool cull_backs = false;
  int unit_bits = 8;
  int spare_bits = 1;                       ///< of FixedPoint, which are dropped
  std::int32_t sample_x = 0, sample_y = 0;  ///< of the sample in its pixel
  FillRule fill_rule = FillRule::top_left;
  int columns = 0, rows = 0;
  /// Triangles that reach this far are large. With at most fast_subpixel_bits every difference has 14 bits, every
  /// product 29, and an edge value up to a vector beyond the box still fits 31.
  std::int32_t large = 1 << 14;
};

/// Triangles whose box has at most this many samples on each side are tested for whether they cover any.
inline constexpr int tiny_side = 4;

/// What became of a block's triangles; bit i is triangle i.
struct AssembledBlock {
  std::uint64_t kept = 0;  ///< drawn, and may cover something: appended to `triangles`
  std::uint64_t left = 0;  ///< to be assembled one by one: cut by something, or large
  /// Numbers of; without what is left.
  std::uint64_t degenerate = 0, back_facing = 0, clipped_away = 0, drawn = 0, coverage_tests = 0;
  FastTriangle* triangles = nullptr;  ///< room for every triangle
};

/// Repeats raster/assembly/assemble.cpp for many triangles at once.
using AssembleBlock = void (*)(const AssemblyRules& rules, const AssemblyBlock& block, AssembledBlock& result);
AssembleBlock assemble_kernel(Simd simd);

/// The triangles of some runs, in order, sorted into the tiles that their boxes touch.
struct FastPart {
  BlockVector<FastTriangle> triangles;
  std::size_t count = 0;
  Batch<float> cut;                       ///< those that were assembled one by one
  std::vector<LargeTriangle> large;       ///< the same
  BlockVector<std::uint32_t> entries;     ///< indices into `triangles`, tile after tile
  std::vector<std::uint32_t> tile_start;  ///< of each tile in `entries`, and the end
  Counters counters;

  std::span<const std::uint32_t> list(std::size_t tile) const {
    return {entries.data() + tile_start[tile], tile_start[tile + 1] - tile_start[tile]};
  }
};

/// Tiles are fast_tile x fast_tile pixels, row by row.
inline constexpr int fast_tile_bits = 6;
inline constexpr int fast_tile = 1 << fast_tile_bits;

/// Assembles all objects in parts, in drawing order. `vertices` come from run_fast_vertices().
std::vector<FastPart> assemble_fast(const RasterInputs<float>& inputs, const std::vector<VertexBuffer<float>>& vertices,
                                    const std::vector<bool>& culled, const ParallelOptions& parallel,
                                    Progress& progress);

}  // namespace ps::raster
