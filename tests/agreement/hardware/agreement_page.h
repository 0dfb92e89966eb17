#pragma once
#include <array>
#include <string>
#include <vector>

#include "agreement/hardware/agreement_matrix.h"
#include "agreement/hardware/driver_ties.h"

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
  TieCount beyond_picture;   ///< of triangles that leave the picture
  StageSplit whole() const;  ///< sums over the rows, without a picture
};

MeasuredMatrix measure_matrix(Renderer hardware);

/// Of the page for this machine's driver in assets/gallery: agreement.md for llvmpipe, agreement-gpu.md for a graphics
/// card.
std::string agreement_page_name();
std::string agreement_page(const MeasuredMatrix& matrix);

}  // namespace ps::test
