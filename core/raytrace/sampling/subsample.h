#pragma once
#include <algorithm>
#include <array>
#include <vector>

#include "base/parallel.h"
#include "raytrace/tracer.h"

namespace ps {

/// Subsampling (CGFS ch. 5) of one tile: the first hit is searched for at every n-th pixel of every n-th row, and at
/// the tile's last column and row. Where the two or four searched pixels around another one saw the same object, or all
/// saw nothing, its ray is tested against what they met alone; shading is done for each pixel. A ray that misses it is
/// searched for. So the picture differs from the plain one only where something smaller than the step lies between.
template <class Real, class Recorder>
class SubsampledTile {
 public:
  SubsampledTile(const Tracer<Real, Recorder>& tracer, const TraceInputs<Real>& inputs, const TileRect& tile, int step)
      : tracer_(tracer), inputs_(inputs), columns_(marks(tile.x0, tile.x1, step)),
        rows_(marks(tile.y0, tile.y1, step)) {
    hits_.reserve(columns_.size() * rows_.size());
    for (const int row : rows_)
      for (const int column : columns_) hits_.push_back(tracer.find(ray_of(column, row)));
  }

  bool is_searched(int column, int row) const {
    return std::binary_search(columns_.begin(), columns_.end(), column) &&
           std::binary_search(rows_.begin(), rows_.end(), row);
  }

  /// A pixel of the tile.
  TracedPixel<Real> pixel(int column, int row) const {
    const Ray<Real> ray = ray_of(column, row);
    const std::size_t x1 = mark_at_or_after(columns_, column), y1 = mark_at_or_after(rows_, row);
    if (columns_[x1] == column && rows_[y1] == row) return tracer_.trace_known(ray, hits_[index(x1, y1)]);
    const std::size_t x0 = columns_[x1] == column ? x1 : x1 - 1, y0 = rows_[y1] == row ? y1 : y1 - 1;
    ReuseEvent event;
    event.seen = seen(hits_[index(x0, y0)]);
    event.same = true;
    std::array<std::uint32_t, 4> primitives{};
    std::size_t count = 0;
    for (std::size_t y = y0; y <= y1; ++y)
      for (std::size_t x = x0; x <= x1; ++x) {
        const Hit<Real>& hit = hits_[index(x, y)];
        event.around[static_cast<std::size_t>(event.count++)] = {columns_[x], rows_[y]};
        event.same = event.same && seen(hit).object == event.seen.object;
        const auto end = primitives.begin() + static_cast<std::ptrdiff_t>(count);
        if (hit.found() && std::find(primitives.begin(), end, hit.primitive) == end)
          primitives[count++] = hit.primitive;
      }
    return tracer_.trace_between(ray, std::span(primitives).first(count), event);
  }

 private:
  static std::vector<int> marks(int begin, int end, int step) {
    std::vector<int> at;
    for (int i = begin; i < end; i += step) at.push_back(i);
    if (at.back() != end - 1) at.push_back(end - 1);
    return at;
  }
  static std::size_t mark_at_or_after(const std::vector<int>& marks, int value) {
    return static_cast<std::size_t>(std::lower_bound(marks.begin(), marks.end(), value) - marks.begin());
  }
  Ray<Real> ray_of(int column, int row) const { return tracer_.eye_ray(column, row, inputs_.viewport.sample); }
  std::size_t index(std::size_t x, std::size_t y) const { return y * columns_.size() + x; }
  PixelId seen(const Hit<Real>& hit) const { return hit.found() ? id_of(*inputs_.geometry, hit) : PixelId{}; }

  const Tracer<Real, Recorder>& tracer_;
  const TraceInputs<Real>& inputs_;
  std::vector<int> columns_, rows_;
  std::vector<Hit<Real>> hits_;
};

}  // namespace ps
