#pragma once
#include <string>
#include <vector>

#include "options/settings.h"
#include "study/stage_causes.h"

namespace ps::test {

/// What two renderers may differ in.
enum class Agreement {
  bounded,   ///< at most 20 of 360,000 triangles, and as many colours
  explained  ///< more, for a reason that `why` states
};

/// Hardware against the rasterizer at the driver's sub-pixel bits: one scene under these assignments, once for each way
/// of rounding vertices.
struct MatrixRow {
  std::string scene;
  std::vector<std::string> assignments;
  Agreement agreement = Agreement::bounded;
  std::string why;    ///< one sentence, where it is `explained`
  int side = 600;     ///< pixels
  std::string name() const;
};

/// A renderer against the ray tracer.
struct RayRow {
  std::string scene;
  std::vector<std::string> assignments;
  std::string why;  ///< one sentence: what differs
};

struct MeasuredRow {
  long pixels = 0, seen = 0;
  StageSplit split;
};

std::vector<MatrixRow> matrix_rows();
std::vector<RayRow> ray_rows();

/// `snapping` is the value of vertex-snapping.
MeasuredRow measure(const MatrixRow& row, Renderer hardware, const std::string& snapping);

/// Colours and ids against the ray tracer.
struct RayDifference {
  long pixels = 0, ids = 0, colours = 0;
  double rms = 0;  ///< of the levels of all channels
};
RayDifference against_rays(const RayRow& row, Renderer renderer);

/// The whole page assets/gallery/agreement.md.
std::string agreement_page(Renderer hardware);

}  // namespace ps::test
