#pragma once
#include <array>
#include <string>
#include <vector>

#include "agreement/hardware/agreement_matrix.h"

namespace ps::test {

/// The matrix as it was measured here.
struct MeasuredMatrix {
  struct Row {
    MatrixRow row;
    std::string snapping;
    StageSplit split;
  };
  struct Ray {
    RayRow row;
    std::array<RayDifference, 2> drawn;  ///< rasterizer, hardware
  };
  std::vector<Row> rows;
  std::vector<Ray> rays;
  StageSplit whole() const;  ///< sums over the rows, without a picture
};

MeasuredMatrix measure_matrix(Renderer hardware);

/// The page assets/gallery/agreement.md.
std::string agreement_page(const MeasuredMatrix& matrix);

}  // namespace ps::test
