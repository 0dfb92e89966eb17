#include <array>
#include <functional>

#include <fmt/format.h>

#include "raster/setup/depth_format.h"
#include "study/stability/support.h"

namespace ps::stability::depth_buffers {
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

/// What each way of storing the depth of a vertex at z holds. Vertices reach a depth buffer as floats, so the float
/// formats get z as a float; the integers get z unrounded, to show what they alone lose.
struct Written {
  std::function<double(double z)> depth;
  bool larger_is_nearer = false;
  bool nearer(double front, double back) const {
    const double a = depth(front), b = depth(back);
    return larger_is_nearer ? a > b : a < b;
  }
};

Written written(const DepthCode& how) {
  return {[how](double z) {
            const double given = how.format == DepthFormat::unorm ? z : static_cast<double>(static_cast<float>(z));
            const double raw = how.value == DepthValue::inverse_z ? 1 / given : given;
            return how.encode(how.format == DepthFormat::plain ? static_cast<double>(static_cast<float>(raw)) : raw);
          },
          how.larger_is_nearer()};
}

/// (A z + B) / z with every step in float, as a vertex shader's matrix and the division after it compute it (Pixelscope
/// encodes in double and has no such format): from 0 to
/// 1 with `low` = 0, as in OpenGL from -1 to 1 with `low` = -1, which is then moved to 0..1 and rounded to 24 bits.
/// Product and quotient are rounded on their own, so far out a gap needs two steps of the format where one would do.
Written by_float_matrix(float low) {
  return {[low](double z) {
    constexpr float near = 0.1f, far = 10000;
    const float a = (far - low * near) / (far - near), b = (low - 1) * far * near / (far - near);
    const auto given = static_cast<float>(z);
    const float depth = (a * given + b) / given;
    if (low == 0) return static_cast<double>(depth);
    return std::floor(static_cast<double>(depth * 0.5f + 0.5f) * 0xffffff + 0.5);
  }};
}

/// The logarithm's share of the range, in 24 bits; not a format of Pixelscope.
Written logarithm() {
  return {[](double z) { return std::floor(std::log2(z / 0.1) / std::log2(10000 / 0.1) * 0xffffff + 0.5); }};
}

/// Percentage of pairs with this gap whose nearer surface, within 5 % of z, does not win.
double confused(const Written& how, double z, double gap, const StabilityRun& run) {
  Random random(run.seed);
  const int pairs = run.count(20000, 4000);
  double wrong = 0;
  for (int i = 0; i < pairs; ++i) {
    const double front = z * random.between(0.95, 1.05);
    wrong += how.nearer(front, front + gap) ? 0 : 1;
  }
  return percent(wrong, pairs);
}

/// Percentage of neighbours a hundred-thousandth of their depth apart that look the same, at depths evenly over the
/// logarithms between the planes.
double same_neighbours(const Written& how, const StabilityRun& run) {
  Random random(run.seed);
  const int pairs = run.count(200000, 20000);
  double same = 0;
  for (int i = 0; i < pairs; ++i) {
    const double z = 0.1 * std::pow(10000 / 0.1, random.unit());
    same += how.nearer(z, z * (1 + 1e-5)) ? 0 : 1;
  }
  return percent(same, pairs);
}

/// The smallest gap at z that 99 % of pairs show; NaN where not even a gap of ten times z is shown.
double smallest_gap(const Written& how, double z, const StabilityRun& run) {
  run.check();
  double low = z * 1e-9, high = z * 10;
  if (confused(how, z, high, run) > 1) return std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 30; ++i) {
    const double middle = std::sqrt(low * high);
    (confused(how, z, middle, run) > 1 ? low : high) = middle;
  }
  return high;
}

void measure_formats(const StabilityRun& run, Rows& rows) {
  struct Format {
    const char* name;
    Written depth;
  };
  DepthCode endless = reversed_float();
  endless.far = 0;
  const Written reversed = written(reversed_float());
  constexpr std::array depths{1.0, 10.0, 100.0, 1000.0, 9000.0};
  std::array<double, depths.size()> robust{};
  for (std::size_t i = 0; i < depths.size(); ++i) robust[i] = smallest_gap(reversed, depths[i], run);
  for (const Format& format :
       {Format{"unorm 24", written(code(DepthFormat::unorm))},
        Format{"float 0..1", written(code(DepthFormat::unit_float))},
        Format{"unorm 16", written(code(DepthFormat::unorm, 16))},
        Format{"unorm 24 reversed", written(code(DepthFormat::unorm, 24, true))},
        Format{"plain 1/z", written(code(DepthFormat::plain))},
        Format{"float reversed, no far plane", written(endless)},
        Format{"float 0..1 by a float matrix", by_float_matrix(0)},
        Format{"-1..1 by a float matrix, to unorm 24", by_float_matrix(-1)}, Format{"unorm 24 of log z", logarithm()},
        Format{"unorm 24 of z", written(code(DepthFormat::unorm, 24, false, DepthValue::z))}}) {
    run.check();
    for (const double gap : {0.001, 0.01, 0.1})
      rows.add(gap, fmt::format("{}, z = 1000", format.name), confused(format.depth, 1000, gap, run),
               confused(reversed, 1000, gap, run), "% of pixels wrong");
    // A gap of z itself, which reaches past the far plane: what hides it hides all smaller ones.
    rows.add(9000, fmt::format("{}, z = 9000", format.name), confused(format.depth, 9000, 9000, run),
             confused(reversed, 9000, 9000, run), "% of pixels wrong");
    for (std::size_t i = 0; i < depths.size(); ++i)
      rows.add(depths[i], fmt::format("{}, resolved", format.name), smallest_gap(format.depth, depths[i], run),
               robust[i], "smallest gap that 99 % of pairs show");
    rows.add(1e-5, fmt::format("{}, any z, gap as a share of z", format.name), same_neighbours(format.depth, run),
             same_neighbours(reversed, run), "% of pairs that look the same");
  }
}

void measure_near(const StabilityRun& run, Rows& rows) {
  constexpr double z = 1000;
  for (const double near : {1.0, 0.1, 0.01, 0.001}) {
    const Written naive = written(code(DepthFormat::unorm, 24, false, DepthValue::inverse_z, near));
    rows.add(near, "z = 1000", smallest_gap(naive, z, run), smallest_gap(written(reversed_float(near)), z, run),
             "smallest gap that 99 % of pairs show");
    rows.add(near, "closed form: z^2 / (near 2^24), z = 1000", z * z / (near * 0x1p24), std::nan(""),
             "width of a code");
  }
}

void measure_linear(const StabilityRun& run, Rows& rows) {
  constexpr double gap = 0.01, step = (10000 - 0.1) / 0xffff;
  const Written naive = written(code(DepthFormat::unorm, 16, false, DepthValue::z));
  const Written robust = written(code(DepthFormat::unorm, 24, false, DepthValue::z));
  for (const double z : {10.0, 100.0, 1000.0, 9000.0}) {
    rows.add(z, "gap 0.01", confused(naive, z, gap, run), confused(robust, z, gap, run), "% of pixels wrong");
    rows.add(z, "closed form: 1 - gap / step, gap 0.01", 100 * (1 - gap / step), std::nan(""), "% of pixels wrong");
  }
}

StabilityPicture sheets() {
  StabilityPicture picture{.scene = "lab/z-fighting"};
  picture.robust = unlit_fragments();
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
  picture.robust.depth_format = DepthFormat::unorm;
  picture.robust.depth_reversed = false;
  picture.robust.depth_value = DepthValue::z;
  picture.naive = picture.robust;
  picture.naive.depth_bits = 16;
  return picture;
}

}  // namespace

extern const StabilityExperiment depth_bits_z_fighting{
    .key = "depth-bits-z-fighting",
    .place = {Subject::depth, 40},
    .set_up = SetUp::reproduction,
    .title = "Z-fighting: surfaces within one depth code",
    .keywords = "z-buffer, zbuffer, depth buffer, depth precision, flicker, stitching",
    .knob = "gap between the two surfaces (world units)",
    .naive = "depth from 0 at the near plane to 1 at the far plane",
    .robust = "float from 1 at the near plane to 0 at the far plane (reversed)",
    .explanation =
        "Z-fighting: the depths of two surfaces round to the same code. There the one that is drawn first shows, which "
        "changes from pixel to pixel and flickers when the camera moves. The near plane is at 0.1 here, the far plane "
        "at 10,000. 1/z has most of its values close behind the near plane, and floats have most of theirs near 0. "
        "Reversed, the two compensate. Reversing an integer buffer gains nothing.",
    .safe = "Gaps above z^2 / (near 2^bits).",
    .window = nowhere_safe,
    .series = {{.names = "unorm 24, z = 1000|*, z = 1000",
                .title = "pixels that show the wrong surface, at depth 1,000",
                .unit = "%",
                .knob = "gap between the two surfaces (world units)",
                .between = Between::nothing},
               {.names = "unorm 24, resolved|*, resolved",
                .title = "smallest gap that 99 % of pairs show",
                .unit = "world units",
                .knob = "depth of the two surfaces (world units)"},
               {.names = "*, z = 9000",
                .title = "pixels that show the wrong surface, at depth 9,000",
                .unit = "%",
                .knob = "gap between the two surfaces (world units)"},
               {.names = "*, any z*",
                .title = "pairs of surfaces that look the same",
                .unit = "%",
                .knob = "gap as a share of the depth"}},
    .add_rows = measure_formats,
    .picture = picture_formats,
    .frames = {0.01}};

extern const StabilityExperiment near_plane{
    .key = "near-plane",
    .place = {Subject::depth, 50},
    .set_up = SetUp::reproduction,
    .title = "Depth precision: a near plane too near",
    .keywords = "z-buffer, zbuffer, depth buffer, z-fighting, depth precision, near clip",
    .knob = "distance of the near plane (world units)",
    .naive = "depth in 24 bits",
    .robust = "reversed float",
    .explanation =
        "At depth z a code of 24 bits is z^2 / (near 2^24) wide. A near plane ten times nearer makes it ten times "
        "wider everywhere.",
    .safe = "The farthest near plane that cuts nothing off.",
    .window = {1, everywhere},
    .series = {{.names = "z = 1000",
                .title = "smallest gap that 99 % of pairs show, at depth 1,000",
                .unit = "world units"},
               {.names = "closed form*",
                .title = "width of a depth code",
                .unit = "world units",
                .naive = "closed form",
                .robust = "none"}},
    .add_rows = measure_near,
    .picture = picture_near,
    .frames = {1.0, 0.1, 0.01, 0.001}};

extern const StabilityExperiment sixteen_bit_linear_z{
    .key = "16-bit-linear-z",
    .place = {Subject::depth, 60},
    .set_up = SetUp::reproduction,
    .title = "Linear depth: 16 bits of z itself",
    .keywords = "z-buffer, zbuffer, depth buffer, w-buffer, depth precision",
    .knob = "depth (world units)",
    .naive = "16 bits of z",
    .robust = "24 bits of z",
    .explanation = "Equal steps of z from 0.1 to 10,000 are 0.15 wide in 16 bits, near and far alike. In 24 bits they "
                   "are 0.0006, but z is not linear on the screen, so it cannot be interpolated there.",
    .safe = "Gaps above 1/65,536 of the range.",
    .window = nowhere_safe,
    .series = {{.names = "gap 0.01|*", .title = "pixels that show the wrong surface", .unit = "%"}},
    .add_rows = measure_linear,
    .picture = picture_linear,
    .frames = {1000.0}};

}  // namespace ps::stability::depth_buffers
