#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "base/parallel.h"
#include "raytrace/clear/tracer.h"
#include "raytrace/sampling/subsample_marks.h"

namespace ps {

/// Subsampling (CGFS ch. 5) of one tile: the first hit is searched for at every n-th pixel of every n-th row, and at
/// the tile's last column and row. Where the two or four searched pixels around another one saw the same object, or all
/// saw nothing, its ray is tested against what they met alone; shading is done for each pixel. A ray that misses it is
/// searched for, and so is one between more than two triangles: among several small ones it mostly meets another. So
/// the picture differs from the plain one only where something smaller than the step lies between.
template <class Real, class Recorder>
class SubsampledTile {
 public:
  SubsampledTile(const Tracer<Real, Recorder>& tracer, const TileRect& tile, int step)
      : tracer_(tracer), inputs_(tracer.inputs()), columns_(subsample_marks(tile.x0, tile.x1, step)),
        rows_(subsample_marks(tile.y0, tile.y1, step)) {
    hits_.resize(columns_.size() * rows_.size());
    std::vector<Ray<Real>> rays;
    for (std::size_t y = 0; y < rows_.size(); ++y) {
      rays.clear();
      for (const int column : columns_) rays.push_back(ray_of(column, rows_[y]));
      tracer_.find(rays, std::span(hits_).subspan(y * columns_.size(), columns_.size()));
    }
  }

  bool is_searched(int column, int row) const {
    return std::binary_search(columns_.begin(), columns_.end(), column) &&
           std::binary_search(rows_.begin(), rows_.end(), row);
  }

  /// A pixel of the tile.
  TracedPixel<Real> pixel(int column, int row) const {
    const Ray<Real> ray = ray_of(column, row);
    const Cell cell = cell_of(column, row);
    if (cell.is_searched()) return tracer_.trace_known(ray, hits_[index(cell.x1, cell.y1)]);
    const Around around = around_of(cell);
    return tracer_.trace_between(ray, around.primitives(), around.event);
  }

  /// Calls use(column, traced pixel) for pixels of a row; those that must be searched for are searched for together.
  template <class Use>
  void trace_pixels(int first_column, int end_column, int row, Use&& use) const {
    std::vector<Ray<Real>> rays, missed;
    std::vector<Hit<Real>> hits, found;
    std::vector<std::size_t> places;
    const auto width = static_cast<std::size_t>(end_column - first_column);
    rays.reserve(width);
    missed.reserve(width);
    hits.reserve(width);
    places.reserve(width);
    Cell last;
    Around around;
    for (int column = first_column; column < end_column; ++column) {
      const Ray<Real> ray = ray_of(column, row);
      rays.push_back(ray);
      const Cell cell = cell_of(column, row);
      if (cell.is_searched()) {
        hits.push_back(hits_[index(cell.x1, cell.y1)]);
        continue;
      }
      if (!(cell == last)) around = around_of(cell);
      last = cell;
      tracer_.recorder().count(Counter::eye_rays);
      hits.push_back(tracer_.find_between(ray, around.primitives(), around.event));
      if (around.event.met) continue;
      places.push_back(rays.size() - 1);
      missed.push_back(ray);
    }
    found.resize(missed.size());
    tracer_.search(missed, found);
    for (std::size_t i = 0; i < places.size(); ++i) hits[places[i]] = found[i];
    TracedPixel<Real> pixel;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      tracer_.trace_known(rays[i], hits[i], pixel);
      use(first_column + static_cast<int>(i), pixel);
    }
  }

 private:
  /// Places of the searched pixels around another in columns_ and rows_, on both sides of it.
  struct Cell {
    std::size_t x0 = 1, x1 = 0, y0 = 1, y1 = 0;
    bool is_searched() const { return x0 == x1 && y0 == y1; }
    bool operator==(const Cell&) const = default;
  };
  Cell cell_of(int column, int row) const {
    const std::size_t x1 = mark_at_or_after(columns_, column), y1 = mark_at_or_after(rows_, row);
    return {columns_[x1] == column ? x1 : x1 - 1, x1, rows_[y1] == row ? y1 : y1 - 1, y1};
  }

  static constexpr std::size_t most_reused = 2;

  /// What they saw.
  struct Around {
    ReuseEvent event;
    std::array<std::uint32_t, 4> list{};
    std::size_t count = 0;
    std::span<const std::uint32_t> primitives() const { return std::span(list).first(count); }
  };
  Around around_of(const Cell& cell) const {
    Around around;
    ReuseEvent& event = around.event;
    event.seen = seen(hits_[index(cell.x0, cell.y0)]);
    event.same = true;
    for (std::size_t y = cell.y0; y <= cell.y1; ++y)
      for (std::size_t x = cell.x0; x <= cell.x1; ++x) {
        const Hit<Real>& hit = hits_[index(x, y)];
        event.around[static_cast<std::size_t>(event.count++)] = {columns_[x], rows_[y]};
        event.same = event.same && seen(hit).object == event.seen.object;
        const auto end = around.list.begin() + static_cast<std::ptrdiff_t>(around.count);
        if (hit.found() && std::find(around.list.begin(), end, hit.primitive) == end)
          around.list[around.count++] = hit.primitive;
      }
    event.same = event.same && around.count <= most_reused;
    return around;
  }

  static std::size_t mark_at_or_after(const std::vector<int>& marks, int value) {
    return static_cast<std::size_t>(std::lower_bound(marks.begin(), marks.end(), value) - marks.begin());
  }
  Ray<Real> ray_of(int column, int row) const { return eye_ray(inputs_, column, row, inputs_.viewport.sample); }
  std::size_t index(std::size_t x, std::size_t y) const { return y * columns_.size() + x; }
  PixelId seen(const Hit<Real>& hit) const { return hit.found() ? id_of(*inputs_.geometry, hit) : PixelId{}; }

  const Tracer<Real, Recorder>& tracer_;
  const TraceInputs<Real>& inputs_;
  std::vector<int> columns_, rows_;
  std::vector<Hit<Real>> hits_;
};

}  // namespace ps
