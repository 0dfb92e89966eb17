#pragma once
#include "options/settings.h"

namespace ps::raster {

/// How coverage is decided (options `coverage` and `edge-arithmetic`).
struct CoverageChoice {
  Coverage strategy = Coverage::edge_function;
  EdgeArithmetic arithmetic = EdgeArithmetic::fixed;  ///< of strategy edge_function alone
  /// What the fast path does as well.
  bool is_common() const { return strategy == Coverage::edge_function && arithmetic == EdgeArithmetic::fixed; }
};

}  // namespace ps::raster
