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

/// Assembles one part; a class only to share what its steps need.
class PartAssembler {
 public:
  PartAssembler(const Pass<float>& pass, const std::vector<VertexBuffer<float>>& vertices, AssembleBlock kernel,
                FastPart& part)
      : pass_(pass), vertices_(vertices), kernel_(kernel), part_(part),
        tile_columns_((pass.viewport.columns + fast_tile - 1) >> fast_tile_bits),
        tiles_(static_cast<std::size_t>(tile_columns_) *
               static_cast<std::size_t>((pass.viewport.rows + fast_tile - 1) >> fast_tile_bits)) {}

  void run(std::span<const TriangleRun> runs) {
    for (const TriangleRun& run : runs) total_ += run.last - run.first;
    part_.triangles.resize(total_ / 2 + TriangleBlock::capacity);
    part_.fragments.resize(2 * total_ + most_fragments);
    order_.resize(2 * total_ + most_fragments);
    part_.tile_start.assign(tiles_ + 1, 0);
    for (const TriangleRun& run : runs)
      for (std::size_t first = run.first; first < run.last; first += TriangleBlock::capacity)
        add_block(run.object, first, std::min<std::size_t>(TriangleBlock::capacity, run.last - first));
    sort_into_tiles();
    part_.counters += part_.cut.counters;
  }

 private:
  void add_block(std::size_t object, std::size_t first, std::size_t count) {
    make_room();
    done_ += count;
    block_.triangles = part_.triangles.data() + part_.count;
    block_.fragments = part_.fragments.data() + part_.fragment_count;
    kernel_(rules(pass_.objects[object]), triangle_block(object, first, count), block_);
    part_.counters[Counter::triangles_in] += count - static_cast<std::size_t>(std::popcount(block_.left));
    part_.counters[Counter::triangles_degenerate] += block_.degenerate;
    part_.counters[Counter::triangles_backfacing] += block_.back_facing;
    part_.counters[Counter::triangles_clipped_away] += block_.clipped_away;
    part_.counters[Counter::triangles_drawn] += block_.drawn;
    part_.counters[Counter::coverage_tests] += block_.coverage_tests;
    for (std::uint64_t rest = block_.kept | block_.left | block_.tiny; rest != 0; rest &= rest - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(rest));
      if ((block_.tiny >> i & 1) != 0)
        note_fragments(block_.fragment_count[i]);
      else if ((block_.left >> i & 1) != 0)
        add_general(object, first + i);
      else
        note_triangle(part_.triangles[part_.count++], whole_triangle);
    }
  }

  TriangleBlock triangle_block(std::size_t object, std::size_t first, std::size_t count) const {
    const DrawObject& drawn = pass_.objects[object];
    TriangleBlock block;
    block.corners = &drawn.corners->positions[first];
    if (drawn.materials.size() > 1) block.triangles = &drawn.mesh->triangles[first];
    block.count = static_cast<int>(count);
    block.points = vertices_[object].camera.data();
    block.places = vertices_[object].places.data();
    block.object = static_cast<std::uint32_t>(object);
    block.first_surface = pass_.first_surface[object];
    block.first = static_cast<std::uint32_t>(first);
    return block;
  }

  /// For whatever a block may bring. Where it is short, for as much as all blocks bring if they go on like this.
  void make_room() {
    const auto enlarge = [&](auto& list, std::size_t used, std::size_t room) {
      if (list.size() >= used + room) return;
      const double whole = static_cast<double>(total_) / static_cast<double>(std::max<std::size_t>(done_, 1));
      list.resize(used + used / 8 + room + static_cast<std::size_t>(static_cast<double>(used) * (whole - 1)));
    };
    enlarge(part_.triangles, part_.count, TriangleBlock::capacity);
    enlarge(part_.fragments, part_.fragment_count, most_fragments);
    enlarge(order_, order_count_, most_fragments);
  }

  /// The next fragments that the kernel made belong to one triangle. Neighbours mostly lie in one tile.
  void note_fragments(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t place = part_.fragments[part_.fragment_count++].place;
      const auto tile = (place >> (16 + fast_tile_bits)) * static_cast<std::uint32_t>(tile_columns_) +
                        ((place & 0xffff) >> fast_tile_bits);
      order_[order_count_++] = tile;
      if (tile != last_tile_) {
        part_.tile_start[last_tile_ + 1] += in_last_tile_;
        last_tile_ = tile;
        in_last_tile_ = 0;
      }
      ++in_last_tile_;
    }
  }

  void note_triangle(const FastTriangle& triangle, std::uint32_t kind) {
    order_[order_count_++] = kind;
    for_tiles(triangle, [&](std::size_t tile) { ++part_.tile_start[tile + 1]; });
  }

  /// A triangle that something cuts, or a large one: in as many pieces as it gives.
  void add_general(std::size_t object, std::size_t triangle) {
    const std::size_t before = part_.cut.triangles.size();
    assemble_triangle(pass_, vertices_[object], object, triangle, part_.cut);
    for (std::size_t i = before; i < part_.cut.triangles.size(); ++i) {
      const ScreenTriangle<float>& piece = part_.cut.triangles[i];
      part_.counters[Counter::coverage_tests] += static_cast<std::uint64_t>(piece.box.x1 - piece.box.x0) *
                                                 static_cast<std::uint64_t>(piece.box.y1 - piece.box.y0);
      part_.large.push_back(large_triangle(piece, pass_.grid));
      FastTriangle general;
      general.shape = FastTriangle::general;
      general.inverse_z = piece.inverse_z;
      general.surface = piece.surface;
      general.object = static_cast<std::uint32_t>(object);
      general.triangle = static_cast<std::uint32_t>(i);
      cut_.push_back(general);
      if (order_count_ == order_.size()) order_.resize(2 * order_count_);
      note_triangle(general, cut_triangle);
    }
  }

  template <class Visit>
  void for_tiles(const FastTriangle& triangle, Visit&& visit) const {
    const PixelBox box = triangle.is_general() ? part_.cut.triangles[triangle.triangle].box : triangle.box();
    for (int row = box.y0 >> fast_tile_bits; row <= (box.y1 - 1) >> fast_tile_bits; ++row)
      for (int column = box.x0 >> fast_tile_bits; column <= (box.x1 - 1) >> fast_tile_bits; ++column)
        visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(tile_columns_) +
              static_cast<std::size_t>(column));
  }

  void sort_into_tiles() {
    part_.tile_start[last_tile_ + 1] += in_last_tile_;
    for (std::size_t t = 0; t < tiles_; ++t) part_.tile_start[t + 1] += part_.tile_start[t];
    part_.entries.resize(part_.tile_start[tiles_]);
    std::vector<std::uint32_t> next(part_.tile_start.begin(), part_.tile_start.end() - 1);
    std::uint32_t triangle = 0, fragment = 0, cut = static_cast<std::uint32_t>(part_.count);
    if (part_.triangles.size() < part_.count + cut_.size()) part_.triangles.resize(part_.count + cut_.size());
    std::copy(cut_.begin(), cut_.end(), part_.triangles.begin() + static_cast<std::ptrdiff_t>(part_.count));
    part_.count += cut_.size();
    for (std::size_t i = 0; i < order_count_; ++i) {
      const std::uint32_t kind = order_[i];
      if (kind < cut_triangle) {
        part_.entries[next[kind]++] = FastPart::fragment | fragment++;
      } else {
        const std::uint32_t number = kind == whole_triangle ? triangle++ : cut++;
        for_tiles(part_.triangles[number], [&](std::size_t t) { part_.entries[next[t]++] = number; });
      }
    }
  }

  AssemblyRules rules(const DrawObject& object) const {
    AssemblyRules rules;
    rules.spare_bits = pass_.grid.subpixel_bits > 0 ? 1 : 0;
    rules.unit_bits = pass_.grid.subpixel_bits + 1 - rules.spare_bits;
    const auto unit = static_cast<double>(1 << rules.unit_bits);
    rules.handedness = static_cast<float>(pass_.camera_space.handedness);
    rules.cull_backs = pass_.settings.backface_culling || object.front_only;
    rules.sample_x = static_cast<std::int32_t>(pass_.grid.sample.x * unit);
    rules.sample_y = static_cast<std::int32_t>(pass_.grid.sample.y * unit);
    rules.fill_rule = pass_.grid.fill_rule;
    rules.columns = pass_.viewport.columns;
    rules.rows = pass_.viewport.rows;
    rules.large = std::int32_t{1} << (rules.unit_bits + 6);  // 64 pixels
    return rules;
  }

  const Pass<float>& pass_;
  const std::vector<VertexBuffer<float>>& vertices_;
  AssembleBlock kernel_;
  FastPart& part_;
  int tile_columns_;
  std::size_t tiles_;
  static constexpr std::size_t most_fragments = TriangleBlock::capacity * tiny_samples;
  static constexpr std::uint32_t whole_triangle = 0xffffffff, cut_triangle = whole_triangle - 1;
  /// What has been added, in order: the tile of a fragment, or which list the triangle is the next of.
  BlockVector<std::uint32_t> order_;
  std::size_t order_count_ = 0;
  std::vector<FastTriangle> cut_;  ///< those assembled one by one; behind the others in the end
  std::size_t total_ = 0, done_ = 0;
  std::uint32_t last_tile_ = 0, in_last_tile_ = 0;
  AssembledBlock block_;
};

}  // namespace

std::vector<FastPart> assemble_fast(const Pass<float>& pass, const std::vector<VertexBuffer<float>>& vertices,
                                    const std::vector<bool>& culled, const ParallelOptions& parallel,
                                    Progress& progress) {
  const std::vector<TriangleRun> runs = make_runs(pass, culled);
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
  const AssembleBlock kernel = assemble_kernel(pass.settings.simd);
  parallel_for(static_cast<int>(parts.size()), parallel, progress, [&](int index, int) {
    const auto i = static_cast<std::size_t>(index);
    PartAssembler(pass, vertices, kernel, parts[i]).run(shares[i]);
  });
  return parts;
}

}  // namespace ps::raster
