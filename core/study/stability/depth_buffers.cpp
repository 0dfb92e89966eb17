#include <array>

#include <fmt/format.h>

#include "raster/depth_format.h"
#include "study/stability/support.h"

namespace ps::stability {
namespace {

using raster::DepthCode;

DepthCode code(DepthFormat format, int bits = 24, bool reversed = false, DepthValue value = DepthValue::inverse_z,
               double near = 0.1) {
  DepthCode code;
  code.value = value;
  code.format = format;
  code.bits = bits;
  code.reversed = reversed;
  code.near = near;
  code.far = 10000;
  return code;
}
DepthCode reversed_float(double near = 0.1) {
  return code(DepthFormat::unit_float, 24, true, DepthValue::inverse_z, near);
}

float encoded(const DepthCode& how, double z) {
  return how.encode(how.value == DepthValue::inverse_z ? static_cast<float>(1 / z) : static_cast<float>(z));
}

/// Percentage of pairs with this gap, from z to a hundredth beyond, whose nearer one does not win.
double confused(const DepthCode& how, double z, double gap, const StabilityRun& run) {
  Random random(run.seed);
  const int pairs = run.count(20000, 4000);
  double wrong = 0;
  for (int i = 0; i < pairs; ++i) {
    const double front = z * random.between(1, 1.01);
    wrong += raster::is_nearer(how, encoded(how, front), encoded(how, front + gap)) ? 0 : 1;
  }
  return percent(wrong, pairs);
}

/// The smallest gap at z that 99 % of pairs show.
double smallest_gap(const DepthCode& how, double z, const StabilityRun& run) {
  run.check();
  double low = z * 1e-9, high = z * 10;
  for (int i = 0; i < 30; ++i) {
    const double middle = std::sqrt(low * high);
    (confused(how, z, middle, run) > 1 ? low : high) = middle;
  }
  return high;
}

std::vector<StabilityRow> measure_formats(const StabilityRun& run) {
  Rows rows(run);
  struct Format {
    const char* name;
    DepthCode code;
  };
  for (const Format& format :
       {Format{"unorm 24", code(DepthFormat::unorm)}, Format{"float 0..1", code(DepthFormat::unit_float)},
        Format{"unorm 16", code(DepthFormat::unorm, 16)},
        Format{"unorm 24 reversed", code(DepthFormat::unorm, 24, true)},
        Format{"plain 1/z", code(DepthFormat::plain)}}) {
    run.check();
    for (const double gap : {0.001, 0.01, 0.1})
      rows.push_back({gap, fmt::format("{}, z = 1000", format.name), confused(format.code, 1000, gap, run),
                      confused(reversed_float(), 1000, gap, run), "% of pixels wrong"});
    for (const double z : {1.0, 10.0, 100.0, 1000.0})
      rows.push_back({z, fmt::format("{}, resolved", format.name), smallest_gap(format.code, z, run),
                      smallest_gap(reversed_float(), z, run), "smallest gap that 99 % of pairs show"});
  }
  return rows;
}

std::vector<StabilityRow> measure_near(const StabilityRun& run) {
  Rows rows(run);
  for (const double near : {1.0, 0.1, 0.01, 0.001})
    rows.push_back({near, "z = 1000",
                    smallest_gap(code(DepthFormat::unorm, 24, false, DepthValue::inverse_z, near), 1000, run),
                    smallest_gap(reversed_float(near), 1000, run), "smallest gap that 99 % of pairs show"});
  return rows;
}

std::vector<StabilityRow> measure_linear(const StabilityRun& run) {
  Rows rows(run);
  for (const double z : {10.0, 100.0, 1000.0, 9000.0})
    rows.push_back({z, "gap 0.01", confused(code(DepthFormat::unorm, 16, false, DepthValue::z), z, 0.01, run),
                    confused(code(DepthFormat::unorm, 24, false, DepthValue::z), z, 0.01, run), "% of pixels wrong"});
  return rows;
}

StabilityPicture sheets() {
  StabilityPicture picture{.scene = "lab/z-fighting"};
  picture.robust.renderer = Renderer::rasterizer;
  picture.robust.lighting = false;
  picture.robust.backface_culling = false;
  picture.robust.near = 0.1;
  picture.robust.far = 10000;
  picture.robust.depth_format = DepthFormat::unit_float;
  picture.robust.depth_reversed = true;
  picture.naive = picture.robust;
  picture.naive.depth_format = DepthFormat::unorm;
  picture.naive.depth_reversed = false;
  return picture;
}
StabilityPicture picture_formats(double) {
  StabilityPicture picture = sheets();
  picture.naive.depth_bits = 16;
  return picture;
}
StabilityPicture picture_near(double near) {
  StabilityPicture picture = sheets();
  picture.naive.near = near;
  return picture;
}
StabilityPicture picture_linear(double) {
  StabilityPicture picture = sheets();
  picture.naive.depth_bits = 16;
  picture.naive.depth_value = DepthValue::z;
  return picture;
}

constexpr std::array gaps{0.01};
constexpr std::array nears{1.0, 0.1, 0.01, 0.001};
constexpr std::array places{1000.0};

}  // namespace

const StabilityExperiment depth_bits_z_fighting{
    .key = "depth-bits-z-fighting",
    .title = "Z-fighting",
    .knob = "gap between two surfaces, or their depth",
    .naive = "depth as 0 at the near plane to 1 at the far one",
    .robust = "reversed float",
    .explanation = "1/z spends most of its values right behind the near plane, and floats spend most of theirs near 0: "
                   "turned round, the two even out. Reversing an integer buffer gains nothing.",
    .safe = "Gaps above z^2 / (near 2^bits).",
    .window = nowhere_safe,
    .measure = measure_formats,
    .picture = picture_formats,
    .frames = gaps};

const StabilityExperiment near_plane{
    .key = "near-plane",
    .title = "A near plane too near",
    .knob = "near plane",
    .naive = "24 bits",
    .robust = "reversed float",
    .explanation =
        "What 24 bits resolve at a depth grows with 1 / near. Moving the near plane ten times nearer costs a "
        "digit everywhere. At 0.001 only 15 codes are left beyond z = 1000, 63 units each, so it counts where z falls "
        "between two of them: the next one begins at 1037.",
    .safe = "The farthest near plane that cuts nothing off.",
    .window = {1, everywhere},
    .measure = measure_near,
    .picture = picture_near,
    .frames = nears};

const StabilityExperiment sixteen_bit_linear_z{
    .key = "16-bit-linear-z",
    .title = "16 bits of z itself",
    .knob = "depth",
    .naive = "16 bits of z",
    .robust = "24 bits of z",
    .explanation = "Even steps of z from 0.1 to 10,000 are 0.15 wide in 16 bits, near and far alike. 24 bits make them "
                   "0.0006, but z is not linear on the screen, so it cannot be stepped from pixel to pixel.",
    .safe = "Gaps above a 65,536th of the range.",
    .window = nowhere_safe,
    .measure = measure_linear,
    .picture = picture_linear,
    .frames = places};

}  // namespace ps::stability
