#include <array>

#include "study/stability/support.h"

namespace ps::stability {
namespace {

constexpr double near_z = 1.5, far_z = 9.5, texels = 512;
constexpr int samples = 4096;

/// Root mean square error (texels) along a floor between two depths, cut into `cells` pieces of equal depth, each of
/// which mixes its texture coordinate evenly over the screen, or u / z and 1 / z.
double rmse(int cells, Interpolation interpolation) {
  double sum = 0;
  const double first = 1 / near_z, last = 1 / far_z;
  for (int i = 0; i < samples; ++i) {
    const double screen = (i + 0.5) / samples;
    const double z = 1 / (first + (last - first) * screen);
    const double share = (z - near_z) / (far_z - near_z);
    const int cell = std::min(static_cast<int>(share * cells), cells - 1);
    const double a = static_cast<double>(cell) / cells, b = static_cast<double>(cell + 1) / cells;
    const double za = near_z + (far_z - near_z) * a, zb = near_z + (far_z - near_z) * b;
    const double s = (1 / z - 1 / za) / (1 / zb - 1 / za);  // along the cell on the screen
    const double u = interpolation == Interpolation::affine
                         ? a + (b - a) * s
                         : (a / za + (b / zb - a / za) * s) / (1 / za + (1 / zb - 1 / za) * s);
    sum += texels * texels * (u - share) * (u - share);
  }
  return std::sqrt(sum / samples);
}

/// Largest error (texels) over the pixel centres of a wall from z = 1 to z = 8 that is 512 px wide and shows 256
/// texels: u / (1 / z) at every `step`-th pixel's left border, u stepped evenly between. Step 1 divides at each centre.
double largest_on_wall(int step) {
  constexpr int width = 512;
  constexpr double first = 1, last = 1.0 / 8, across = 256;
  const auto exact = [](double x) {  // u z grows from 0 to `across` at the far end
    const double s = x / width;
    return s * across * last / (first + (last - first) * s);
  };
  double largest = 0;
  for (int x = 0; x < width; ++x) {
    const double centre = x + 0.5;
    const int left = x / step * step;
    const double a = exact(left), b = exact(std::min(left + step, width));
    const double u = step == 1 ? exact(centre) : a + (b - a) * (centre - left) / (std::min(left + step, width) - left);
    // The wall is straight: where a ray through the pixel meets it.
    const double z = width / (width * first + (last - first) * centre);
    const double truth = across * (z - 1) / (1 / last - 1);
    largest = std::max(largest, std::abs(u - truth));
  }
  return largest;
}

std::vector<StabilityRow> measure(const StabilityRun& run) {
  Rows rows(run);
  for (const int cells : {1, 2, 4, 8, 16, 32, 64, 128})
    rows.push_back({static_cast<double>(cells), "floor from z = 1.5 to 9.5", rmse(cells, Interpolation::affine),
                    rmse(cells, Interpolation::perspective), "texels of 512 (RMSE)"});
  for (const int step : {4, 8, 16, 32, 64, 512})
    rows.push_back({static_cast<double>(step), "wall from z = 1 to 8, px between divisions", largest_on_wall(step),
                    largest_on_wall(1), "texels of 256 (largest)"});
  return rows;
}

StabilityPicture picture(double) {
  StabilityPicture picture{.scene = "cgfs/crates"};
  picture.robust.renderer = Renderer::rasterizer;
  picture.naive = picture.robust;
  picture.naive.interpolation = Interpolation::affine;
  return picture;
}

constexpr std::array frames{1.0};

}  // namespace

const StabilityExperiment affine_texture{
    .key = "affine-texture",
    .title = "Affine textures",
    .knob = "pieces along the floor",
    .naive = "mix u on the screen",
    .robust = "mix u / z and 1 / z",
    .explanation = "Equal steps on the screen are not equal steps on a surface that runs away from the eye. Cutting it "
                   "into twice as many pieces divides the error by four.",
    .safe = "Pieces of up to 14 pixels for a third of a texel.",
    .window = {64, everywhere},
    .measure = measure,
    .picture = picture,
    .frames = frames};

}  // namespace ps::stability
