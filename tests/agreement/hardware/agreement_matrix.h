#pragma once
#include <string>
#include <vector>

#include "options/settings.h"
#include "study/stage_causes.h"

namespace ps::test {

/// For which ways of rounding vertices more than the bound differs.
enum class Explained { for_both, for_driver };

/// Hardware against the rasterizer at the driver's sub-pixel bits: one scene under these assignments. Unless they say
/// otherwise without shadows, reflections and environment maps.
struct MatrixRow {
  std::string scene;
  std::vector<std::string> assignments{};
  int side = 300;     ///< pixels
  std::string why{};  ///< one sentence, where more than the bound differs; empty: the bound holds
  Explained explained = Explained::for_both;
  std::string name() const;
  bool holds_bound(const std::string& snapping) const {
    return why.empty() || (explained == Explained::for_driver && snapping != "driver");
  }
  /// Triangles that may differ, and as many colours: 20 of 360,000 pixels.
  long bound() const { return 20L * side * side / 360000; }
};

/// The renderers of triangles against the ray tracer, in pictures of 300 x 300 pixels.
struct RayRow {
  std::string scene;
  std::vector<std::string> assignments{};
  std::string why;  ///< one sentence: what differs
  std::string name() const;
};

std::vector<MatrixRow> scene_rows();
std::vector<MatrixRow> option_rows();
std::vector<RayRow> ray_rows();

/// `snapping` is the value of vertex-snapping.
StageSplit measure(const MatrixRow& row, Renderer hardware, const std::string& snapping);

struct RayDifference {
  long ids = 0;
  long colours = 0;  ///< that differ by more than one level of 255
  double rms = 0;    ///< of the levels of all channels
};
RayDifference against_rays(const RayRow& row, Renderer renderer);

}  // namespace ps::test
