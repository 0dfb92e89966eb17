#pragma once
#include <limits>
#include <optional>

#include "raster/clear/coverage/input.h"

namespace ps::raster {

/// Where an edge cuts the rows: a digital differential analyser that keeps whole columns and an error, so that it never
/// drifts (CGPP 15.6.6.3, after Bresenham).
class EdgeColumn {
 public:
  /// `value` is the edge's at column 0 of the first row. step_x must not be 0.
  EdgeColumn(std::int64_t value, std::int64_t step_x, std::int64_t step_y, std::int64_t threshold)
      : left_(step_x > 0), divisor_(left_ ? step_x : -step_x) {
    // Left edges: inside from the first column with value + step_x * column > threshold on. Right ones: up to the last.
    const std::int64_t error = left_ ? threshold - value : value - threshold - 1;
    column_ = floor_divide(error, divisor_);
    error_ = error - column_ * divisor_;
    const std::int64_t step = left_ ? -step_y : step_y;
    column_step_ = floor_divide(step, divisor_);
    error_step_ = step - column_step_ * divisor_;
  }
  bool is_left() const { return left_; }
  /// The first column inside a left edge, or the last one inside a right edge.
  std::int64_t column() const { return left_ ? column_ + 1 : column_; }
  void next_row() {
    column_ += column_step_;
    error_ += error_step_;
    if (error_ >= divisor_) {
      error_ -= divisor_;
      ++column_;
    }
  }

 private:
  bool left_;
  std::int64_t divisor_;
  std::int64_t column_ = 0, error_ = 0;
  std::int64_t column_step_ = 0, error_step_ = 0;
};

/// Columns of a row, both inclusive; empty if last < first.
struct RowSpan {
  std::int64_t first = std::numeric_limits<std::int64_t>::min();
  std::int64_t last = std::numeric_limits<std::int64_t>::max();
};

/// Goes down the triangle's rows along its left and right edges. The triangle is cut at its middle vertex: each row
/// uses the two edges that reach it, so there is nothing to test for the samples between them.
class SpanWalk {
 public:
  SpanWalk(const CoverageInput& input, int first_row) : row_(first_row), input_(input) {
    const auto values = input.edges.at(0, first_row);
    for (std::size_t i = 0; i < 3; ++i)
      if (input.edges.step_x[i] != 0)
        column_[i].emplace(values[i], input.edges.step_x[i], input.edges.step_y[i], input.edges.threshold[i]);
  }
  RowSpan span() const {
    const std::int64_t y = row_ * fixed_unit(input_.grid.subpixel_bits) + sample_offset(input_.grid).y;
    RowSpan span;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t a = input_.corners[(i + 1) % 3].y, b = input_.corners[(i + 2) % 3].y;
      if (y < std::min(a, b) || y > std::max(a, b)) continue;
      if (!column_[i]) {  // a horizontal edge runs through the samples: its owner has the row, the other one has not
        if (input_.edges.threshold[i] >= 0) return {0, -1};
      } else if (column_[i]->is_left()) {
        span.first = std::max(span.first, column_[i]->column());
      } else {
        span.last = std::min(span.last, column_[i]->column());
      }
    }
    return span;
  }
  void next_row() {
    ++row_;
    for (auto& column : column_)
      if (column) column->next_row();
  }

 private:
  int row_;
  const CoverageInput& input_;
  std::array<std::optional<EdgeColumn>, 3> column_;
};

/// Row by row, from the left edge to the right one.
template <class Sink>
void walk_scanlines(const CoverageInput& input, const TileRect& box, Sink& sink) {
  SpanWalk walk(input, box.y0);
  for (int row = box.y0; row < box.y1; ++row, walk.next_row()) {
    const RowSpan span = walk.span();
    const auto first = static_cast<int>(std::max<std::int64_t>(span.first, box.x0));
    const auto last = static_cast<int>(std::min<std::int64_t>(span.last, box.x1 - 1));
    sink.region({first, row, std::max(first, last + 1), row + 1});
    for (int column = first; column <= last; ++column) sink.cover(column, row);
  }
}

}  // namespace ps::raster
