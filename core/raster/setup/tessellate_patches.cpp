#include "raster/setup/tessellate_patches.h"

#include <algorithm>
#include <cmath>

#include "math/unit.h"
#include "scene/generate/bezier_patch.h"

namespace ps::raster {
namespace {

constexpr int edge_samples = 8;  // along each edge of a patch
constexpr double between_samples = 1.1;

/// By how many pixels two triangles for the whole patch could stray from it.
double undivided_error(const BezierPatch& patch, const TessellationView& view) {
  double worst = 0;
  for (int row = 0; row <= edge_samples; ++row)
    for (int column = 0; column <= edge_samples; ++column) {
      const PatchBend bend = patch_bend(patch, {column, edge_samples}, {row, edge_samples});
      const double strays = (std::abs(bend.uu) + 2 * std::abs(bend.uv) + std::abs(bend.vv)) / 8;
      const Vec3d from_eye = bend.point - view.eye;
      const bool shrinks = view.projection == Projection::perspective;
      const double distance = shrinks ? std::max(length_of(from_eye), view.nearest) : 1;
      worst = std::max(worst, strays * view.pixels_per_unit / distance);
    }
  return worst * between_samples;
}

}  // namespace

int patch_divisions(const std::vector<BezierPatch>& world, const TessellationView& view) {
  double divisions = 1;
  for (const BezierPatch& patch : world)
    divisions = std::max(divisions, std::ceil(std::sqrt(undivided_error(patch, view) / view.max_error)));
  return static_cast<int>(std::min<double>(divisions, most_patch_divisions));
}

}  // namespace ps::raster
