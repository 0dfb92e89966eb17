#include "raster/fast/assembly.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

namespace ps::raster {
namespace {

constexpr std::size_t least_per_part = 2048;
constexpr std::size_t most_assembly_parts = 64;

LargeTriangle large_triangle(const ScreenTriangle<float>& piece, const CoverageGrid& grid) {
  LargeTriangle large;
  large.edges = *make_edges(piece.corners, grid);
  large.inverse_area = 1.0f / static_cast<float>(large.edges.area);
  const auto within = [](std::int64_t v, int bits) { return std::abs(v) <= std::int64_t{1} << bits; };
  large.fits_double = true;
  for (const int row : {piece.box.y0, piece.box.y1})
    for (const int column : {piece.box.x0, piece.box.x1})
      for (const std::int64_t value : large.edges.at(column, row))
        large.fits_double = large.fits_double && within(value, 51);
  for (std::size_t i = 0; i < 3; ++i)
    large.fits_double = large.fits_double && within(large.edges.step_x[i], 43) && within(large.edges.step_y[i], 43);
  return large;
}

/// Assembles one part; the members are what its steps share.
class PartAssembler {
 public:
  PartAssembler(const RasterInputs<float>& inputs, const std::vector<VertexBuffer<float>>& vertices,
                AssembleBlock kernel, FastPart& part)
      : inputs_(inputs), vertices_(vertices), kernel_(kernel), part_(part),
        tile_columns_((inputs.viewport.columns + fast_tile - 1) >> fast_tile_bits),
        tiles_(static_cast<std::size_t>(tile_columns_) *
               static_cast<std::size_t>((inputs.viewport.rows + fast_tile - 1) >> fast_tile_bits)) {}

  void run(std::span<const TriangleRun> runs) {
    for (const TriangleRun& run : runs) total_ += run.last - run.first;
    part_.triangles.resize(total_ / 2 + AssemblyBlock::capacity);
    part_.tile_start.assign(tiles_ + 1, 0);
    for (const TriangleRun& run : runs)
      for (std::size_t first = run.first; first < run.last; first += AssemblyBlock::capacity)
        add_block(run.object, first, std::min<std::size_t>(AssemblyBlock::capacity, run.last - first));
    sort_into_tiles();
    part_.counters += part_.cut.counters;
  }

 private:
  void add_block(std::size_t object, std::size_t first, std::size_t count) {
    make_room();
    done_ += count;
    block_.triangles = part_.triangles.data() + part_.count;
    kernel_(rules(inputs_.objects[object]), triangle_block(object, first, count), block_);
    part_.counters[Counter::triangles_in] += count - static_cast<std::size_t>(std::popcount(block_.left));
    part_.counters[Counter::triangles_degenerate] += block_.degenerate;
    part_.counters[Counter::triangles_backfacing] += block_.back_facing;
    part_.counters[Counter::triangles_clipped_away] += block_.clipped_away;
    part_.counters[Counter::triangles_drawn] += block_.drawn;
    part_.counters[Counter::coverage_tests] += block_.coverage_tests;
    if (block_.left != 0)
      add_left(object, first);
    else
      part_.count += static_cast<std::size_t>(std::popcount(block_.kept));
  }

  /// The kernel's triangles, and between them those that it has left, in order.
  void add_left(std::size_t object, std::size_t first) {
    std::array<FastTriangle, AssemblyBlock::capacity> kept;
    std::copy_n(part_.triangles.begin() + static_cast<std::ptrdiff_t>(part_.count), std::popcount(block_.kept),
                kept.begin());
    std::size_t next = 0;
    for (std::uint64_t rest = block_.kept | block_.left; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(rest));
      if ((block_.left >> i & 1) != 0)
        add_general(object, first + i);
      else
        add(kept[next++]);
    }
  }

  AssemblyBlock triangle_block(std::size_t object, std::size_t first, std::size_t count) const {
    const DrawObject& drawn = inputs_.objects[object];
    AssemblyBlock block;
    block.corners = &drawn.corners->positions[first];
    if (drawn.materials.size() > 1) block.triangles = &drawn.mesh->triangles[first];
    block.count = static_cast<int>(count);
    block.points = vertices_[object].camera.data();
    block.places = vertices_[object].places.data();
    block.object = static_cast<std::uint32_t>(object);
    block.first_surface = inputs_.first_surface[object];
    block.first = static_cast<std::uint32_t>(first);
    return block;
  }

  /// For whatever a block may bring. Where it is short, for as much as all blocks bring if they go on like this.
  void make_room() {
    if (part_.triangles.size() >= part_.count + AssemblyBlock::capacity) return;
    const double share = static_cast<double>(part_.count) / static_cast<double>(std::max<std::size_t>(done_, 1));
    part_.triangles.resize(part_.count + part_.count / 8 + AssemblyBlock::capacity +
                           static_cast<std::size_t>(share * static_cast<double>(total_ - done_)));
  }

  void add(const FastTriangle& triangle) {
    if (part_.count == part_.triangles.size()) part_.triangles.resize(part_.count + part_.count / 2 + 16);
    part_.triangles[part_.count++] = triangle;
  }

  /// A triangle that something cuts, or a large one: in as many pieces as it gives.
  void add_general(std::size_t object, std::size_t triangle) {
    const std::size_t before = part_.cut.triangles.size();
    assemble_triangle(inputs_, vertices_[object], object, triangle, part_.cut);
    for (std::size_t i = before; i < part_.cut.triangles.size(); ++i) {
      const ScreenTriangle<float>& piece = part_.cut.triangles[i];
      part_.counters[Counter::coverage_tests] += static_cast<std::uint64_t>(piece.box.x1 - piece.box.x0) *
                                                 static_cast<std::uint64_t>(piece.box.y1 - piece.box.y0);
      part_.large.push_back(large_triangle(piece, inputs_.grid));
      FastTriangle general;
      general.shape = FastTriangle::general;
      general.inverse_z = piece.inverse_z;
      general.surface = piece.surface;
      general.object = static_cast<std::uint32_t>(object);
      general.triangle = static_cast<std::uint32_t>(i);
      add(general);
    }
  }

  template <class Visit>
  void for_tiles(const FastTriangle& triangle, Visit&& visit) const {
    const TileRect box = triangle.is_general() ? part_.cut.triangles[triangle.triangle].box : triangle.box();
    for (int row = box.y0 >> fast_tile_bits; row <= (box.y1 - 1) >> fast_tile_bits; ++row)
      for (int column = box.x0 >> fast_tile_bits; column <= (box.x1 - 1) >> fast_tile_bits; ++column)
        visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(tile_columns_) +
              static_cast<std::size_t>(column));
  }

  void sort_into_tiles() {
    const std::span<const FastTriangle> triangles(part_.triangles.data(), part_.count);
    for (const FastTriangle& triangle : triangles)
      for_tiles(triangle, [&](std::size_t tile) { ++part_.tile_start[tile + 1]; });
    for (std::size_t t = 0; t < tiles_; ++t) part_.tile_start[t + 1] += part_.tile_start[t];
    part_.entries.resize(part_.tile_start[tiles_]);
    std::vector<std::uint32_t> next(part_.tile_start.begin(), part_.tile_start.end() - 1);
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
      for_tiles(triangles[i], [&](std::size_t tile) { part_.entries[next[tile]++] = i; });
  }

  AssemblyRules rules(const DrawObject& object) const {
    AssemblyRules rules;
    rules.spare_bits = inputs_.grid.subpixel_bits > 0 ? 1 : 0;
    rules.unit_bits = inputs_.grid.subpixel_bits + 1 - rules.spare_bits;
    const auto unit = static_cast<double>(1 << rules.unit_bits);
    rules.handedness = static_cast<float>(facing_sense(inputs_, object));
    rules.cull_backs = inputs_.settings.backface_culling || object.front_only;
    rules.sample_x = static_cast<std::int32_t>(inputs_.grid.sample.x * unit);
    rules.sample_y = static_cast<std::int32_t>(inputs_.grid.sample.y * unit);
    rules.fill_rule = inputs_.grid.fill_rule;
    rules.columns = inputs_.viewport.columns;
    rules.rows = inputs_.viewport.rows;
    rules.large = std::int32_t{1} << (rules.unit_bits + 6);  // 64 pixels
    return rules;
  }

  const RasterInputs<float>& inputs_;
  const std::vector<VertexBuffer<float>>& vertices_;
  AssembleBlock kernel_;
  FastPart& part_;
  int tile_columns_;
  std::size_t tiles_;
  std::size_t total_ = 0, done_ = 0;  ///< triangles in all, and so far
  AssembledBlock block_;
};

}  // namespace

std::vector<FastPart> assemble_fast(const RasterInputs<float>& inputs, const std::vector<VertexBuffer<float>>& vertices,
                                    const std::vector<bool>& culled, const ParallelOptions& parallel,
                                    Progress& progress) {
  const std::vector<TriangleRun> runs = make_runs(inputs, culled);
  std::size_t total = 0;
  for (const TriangleRun& run : runs) total += run.last - run.first;
  const std::size_t enough = std::max(least_per_part, total / most_assembly_parts);
  std::vector<std::span<const TriangleRun>> shares;
  for (std::size_t first = 0; first < runs.size();) {
    std::size_t last = first;
    for (std::size_t triangles = 0; last < runs.size() && triangles < enough; ++last)
      triangles += runs[last].last - runs[last].first;
    shares.push_back(std::span(runs).subspan(first, last - first));
    first = last;
  }
  std::vector<FastPart> parts(shares.size());
  const AssembleBlock kernel = assemble_kernel(inputs.settings.simd);
  parallel_for(static_cast<int>(parts.size()), parallel, progress, [&](int index, int) {
    const auto i = static_cast<std::size_t>(index);
    PartAssembler(inputs, vertices, kernel, parts[i]).run(shares[i]);
  });
  return parts;
}

}  // namespace ps::raster
