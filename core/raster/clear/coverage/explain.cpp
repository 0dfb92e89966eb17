#include "raster/clear/coverage/explain.h"

#include <fmt/format.h>

namespace ps::raster {
namespace {

struct Explanation {
  std::string how;
  std::vector<double> values;
};

/// The first of three numbers that keeps the sample out; -1 if none does.
template <class Number>
int failing(const std::array<Number, 3>& values, const std::array<std::int64_t, 3>& threshold) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!inside_edge(values[i], threshold[i])) return static_cast<int>(i);
  return -1;
}

std::vector<double> in_square_pixels(const std::array<std::int64_t, 3>& values, int subpixel_bits) {
  const auto unit = static_cast<double>(fixed_unit(subpixel_bits));
  std::vector<double> scaled;
  scaled.reserve(values.size());
  for (const std::int64_t value : values) scaled.push_back(static_cast<double>(value) / (unit * unit));
  return scaled;
}

Explanation explain_rays(const CoverageInput& input, int column, int row) {
  const auto sides = ray_sides(input, column, row);
  const int edge = failing(sides, input.edges.threshold);
  return {edge < 0 ? "the ray passes on the inner side of all three edges"
                   : fmt::format("the ray passes outside edge {}", edge),
          in_square_pixels(sides, input.grid.subpixel_bits)};
}

template <class Real>
Explanation explain_weights(const CoverageInput& input, const std::array<Real, 3>& weights) {
  const int corner = failing(weights, input.edges.threshold);
  const std::vector<double> values(weights.begin(), weights.end());
  if (corner < 0) return {"no weight is negative", values};
  const auto k = static_cast<std::size_t>(corner);
  return {fmt::format("the weight of vertex {} is {}", corner,
                      weights[k] == 0 ? "0, on an edge that the neighbour owns" : "negative"),
          values};
}

Explanation explain_span(const CoverageInput& input, int column, int row) {
  const RowSpan span = SpanWalk(input, row).span();
  const std::vector<double> values{static_cast<double>(span.first), static_cast<double>(span.last)};
  if (span.first > span.last) return {fmt::format("row {} covers none of its samples", row), {}};
  const std::string text = fmt::format("row {} is covered from column {} to {}", row, span.first, span.last);
  if (column < span.first) return {text + "; this sample lies left of them", values};
  if (column > span.last) return {text + "; this sample lies right of them", values};
  return {text, values};
}

std::string_view verdict_text(CellVerdict verdict) {
  switch (verdict) {
  case CellVerdict::outside:
    return "outside edge";
  case CellVerdict::inside:
    return "inside";
  case CellVerdict::partly:
    return "cut by edge";
  }
  return "";
}

std::string cell_text(int size, const CellTest& test) {
  const std::string edge = test.edge >= 0 ? fmt::format(" {}", test.edge) : "";
  return fmt::format("its cell of {} is {}{}", size, verdict_text(test.verdict), edge);
}

Explanation explain_cells(const CoverageInput& input, int column, int row) {
  Explanation explanation;
  for (int size = coarsest_cell; size > 1; size /= cells_across) {
    const int x = cell_start(column, size), y = cell_start(row, size);
    const CellTest test = test_cell(input.edges, common_part({x, y, x + size, y + size}, input.whole));
    explanation.how += (explanation.how.empty() ? "" : ", ") + cell_text(size, test);
    if (test.verdict != CellVerdict::partly) return explanation;
  }
  const auto values = input.edges.at(column, row);
  const int edge = failing(values, input.edges.threshold);
  explanation.how += edge < 0 ? ", the sample is inside" : fmt::format(", the sample is outside edge {}", edge);
  explanation.values = in_square_pixels(values, input.grid.subpixel_bits);
  return explanation;
}

Explanation explain_tile(const CoverageInput& input, int column, int row) {
  const int x = cell_start(column, mask_tile), y = cell_start(row, mask_tile);
  const CellTest test = test_cell(input.edges, common_part({x, y, x + mask_tile, y + mask_tile}, input.whole));
  if (test.verdict != CellVerdict::partly) return {cell_text(mask_tile, test), {}};
  std::array<std::uint64_t, 3> mask;
  for (std::size_t i = 0; i < 3; ++i) mask[i] = edge_mask(input.edges, i, x, y);
  const int bit = mask_tile * (row - y) + column - x;
  const bool set = ((mask[0] & mask[1] & mask[2]) >> bit & 1) != 0;
  return {fmt::format("tile at ({}, {}): masks {:016x} & {:016x} & {:016x}, bit {} is {}", x, y, mask[0], mask[1],
                      mask[2], bit, set ? "set" : "clear"),
          {}};
}

Explanation explain_pieces(const CoverageInput& input, bool covered) {
  const int levels = Micropolygons(input).levels();
  return {fmt::format("split {} times into four, {} pieces in all: {}", levels, std::int64_t{1} << (2 * levels),
                      covered ? "one of them covers the sample" : "none of them covers the sample"),
          {}};
}

/// Edge functions in other arithmetic: what it computed, and what the exact value is.
Explanation explain_edges(const CoverageChoice& choice, const CoverageInput& input, int column, int row) {
  const auto exact = input.edges.at(column, row);
  const float x = float_sample(column, input.grid.sample.x), y = float_sample(row, input.grid.sample.y);
  switch (choice.arithmetic) {
  case EdgeArithmetic::fixed:
    return {"edge values in 64-bit integers", in_square_pixels(exact, input.grid.subpixel_bits)};
  case EdgeArithmetic::float32: {
    const FloatEdges edges = make_float_edges(input);
    return {"edge values in float", {edges.at(0, x, y), edges.at(1, x, y), edges.at(2, x, y)}};
  }
  case EdgeArithmetic::float_stepped:
    return {fmt::format("edge values in float, {} additions from the triangle's first sample",
                        column - input.whole.x0 + row - input.whole.y0),
            {}};
  case EdgeArithmetic::int32: {
    std::array<std::int64_t, 3> values;
    bool overflow = false;
    for (std::size_t i = 0; i < 3; ++i) {
      values[i] = wrapped(exact[i], input.grid.subpixel_bits);
      overflow = overflow || (values[i] < 0) != (exact[i] < 0);
    }
    return {overflow ? "edge values overflow 32 bits and change their sign" : "edge values in 32-bit integers",
            in_square_pixels(values, input.grid.subpixel_bits - 1)};
  }
  }
  return {};
}

template <class Real>
Explanation explain(const CoverageChoice& choice, const CoverageInput& input, int column, int row, bool covered) {
  switch (choice.strategy) {
  case Coverage::edge_function:
    return explain_edges(choice, input, column, row);
  case Coverage::ray_test:
  case Coverage::bounding_box:
    return explain_rays(input, column, row);
  case Coverage::barycentric:
    return explain_weights<Real>(input, barycentric_weights<Real>(input, column, row));
  case Coverage::hoisted:
    return explain_weights<Real>(input, hoisted_weights<Real>(input, column, row));
  case Coverage::scanline:
    return explain_span(input, column, row);
  case Coverage::hierarchical:
    return explain_cells(input, column, row);
  case Coverage::tiled:
    return explain_tile(input, column, row);
  case Coverage::micropolygon:
    return explain_pieces(input, covered);
  }
  return {};
}

}  // namespace

template <class Real>
CoverageEvent explain_coverage(const CoverageChoice& choice, const CoverageInput& input, int column, int row) {
  const OnePixelSink decision = decide_sample<Real>(choice, input, column, row);
  CoverageEvent event;
  event.strategy = choice.strategy;
  event.covered = decision.covered;
  event.tests = decision.tests;
  const bool everywhere = choice.strategy == Coverage::ray_test;
  if (!everywhere && is_empty(common_part({column, row, column + 1, row + 1}, input.whole))) {
    event.how = "outside the triangle's bounding box";
    return event;
  }
  Explanation explanation = explain<Real>(choice, input, column, row, decision.covered);
  event.how = std::move(explanation.how);
  event.values = std::move(explanation.values);
  if (decision.covered != input.edges.inside(input.edges.at(column, row)))
    event.how += decision.covered ? "; exactly, the sample lies outside" : "; exactly, the sample lies inside";
  return event;
}

template CoverageEvent explain_coverage<float>(const CoverageChoice&, const CoverageInput&, int, int);
template CoverageEvent explain_coverage<double>(const CoverageChoice&, const CoverageInput&, int, int);

}  // namespace ps::raster
