#pragma once
#include "raster/base/coverage_choice.h"
#include "raster/clear/coverage/barycentric.h"
#include "raster/clear/coverage/hierarchical.h"
#include "raster/clear/coverage/hoisted.h"
#include "raster/clear/coverage/incremental.h"
#include "raster/clear/coverage/micropolygon.h"
#include "raster/clear/coverage/ray_test.h"
#include "raster/clear/coverage/scanline.h"
#include "raster/clear/coverage/tiled.h"

namespace ps::raster {

/// Finds the covered samples of a box that is not empty and lies in the picture. All strategies find the same ones,
/// except barycentric and hoisted in float and edge functions in arithmetic that is not fixed.
template <class Real, class Sink>
void walk_coverage(const CoverageChoice& choice, const CoverageInput& input, const TileRect& box, Sink& sink) {
  switch (choice.strategy) {
  case Coverage::edge_function:
    switch (choice.arithmetic) {
    case EdgeArithmetic::fixed:
      return walk_incremental(input, box, sink);
    case EdgeArithmetic::float32:
      return walk_float_edges(input, box, sink);
    case EdgeArithmetic::float_stepped:
      return walk_stepped_edges(input, box, sink);
    case EdgeArithmetic::int32:
      return walk_wrapped_edges(input, box, sink);
    }
    return;
  case Coverage::ray_test:
  case Coverage::bounding_box:
    return walk_rays(input, box, sink);
  case Coverage::barycentric:
    return walk_barycentric<Real>(input, box, sink);
  case Coverage::hoisted:
    return walk_hoisted<Real>(input, box, sink);
  case Coverage::scanline:
    return walk_scanlines(input, box, sink);
  case Coverage::hierarchical:
    return walk_hierarchy(input, box, sink);
  case Coverage::tiled:
    return walk_tiles(input, box, sink);
  case Coverage::micropolygon:
    return walk_micropolygons(input, box, sink);
  }
}

/// A sink that only wants to know about one pixel.
struct OnePixelSink {
  bool covered = false;
  int tests = 0;
  void test(int, int) { ++tests; }
  void test_all(const TileRect&) { ++tests; }
  void region(const TileRect&) { ++tests; }
  template <class... Values>
  void cover(int, int, const Values&...) {
    covered = true;
  }
};

/// What the strategy decides about one sample.
template <class Real>
OnePixelSink decide_sample(const CoverageChoice& choice, const CoverageInput& input, int column, int row) {
  OnePixelSink sink;
  const bool everywhere = choice.strategy == Coverage::ray_test;
  const TileRect pixel{column, row, column + 1, row + 1};
  if (everywhere || !is_empty(common_part(pixel, input.whole))) walk_coverage<Real>(choice, input, pixel, sink);
  return sink;
}

}  // namespace ps::raster
