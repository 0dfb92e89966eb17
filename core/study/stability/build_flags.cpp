#include <fmt/format.h>

#include "study/stability/build_flags/kernels.h"
#include "study/stability/triangle_methods.h"

namespace ps::stability::build_flags {
namespace {

std::vector<StabilityRow> measure_contraction(const StabilityRun& run) {
  Rows rows(run);
  const FlagBuild plain = plain_build(), fused = contracted_build();
  if (!fused.available()) return rows;
  const auto hits = [](auto test) -> TriangleHits {
    return
        [test](const AimedRay& ray, const TracedTriangle<float>& triangle) { return test(flat(ray), flat(triangle)); };
  };
  const std::vector<CrackRates> rates = crack_rates(
      AimAt::edge,
      {watertight_hits, hits(fused.watertight), hits(plain.watertight), hits(fused.moeller_trumbore),
       hits(plain.moeller_trumbore), fused_edges_hits, hits(fused.compared_products), hits(fused.kahan_products)},
      run);
  const CrackRates &product = rates[0], &fused_woop = rates[1], &plain_woop = rates[2];
  rows.push_back({1, "watertight (Woop)", fused_woop.misses, plain_woop.misses, "misses per million"});
  rows.push_back({1, "watertight (Woop), double hits", fused_woop.doubles, plain_woop.doubles, "per million rays"});
  add_cracks(rows, 1, "edge functions alone fused, at edges", rates[5], plain_woop);
  rows.push_back({1, "cured: products compared", fused_woop.misses, rates[6].misses, "misses per million"});
  rows.push_back({1, "cured: Kahan's products", fused_woop.misses, rates[7].misses, "misses per million"});
  rows.push_back({1, "Moeller-Trumbore", rates[3].misses, product.misses, "misses per million"});
  rows.push_back({0, "Moeller-Trumbore", rates[4].misses, product.misses, "misses per million"});
  for (const auto& [what, where] : {std::pair{AimAt::vertex, "at vertices"}, {AimAt::interior, "inside triangles"}}) {
    const std::vector<CrackRates> others =
        crack_rates(what, {hits(fused.watertight), hits(plain.watertight), fused_edges_hits}, run);
    add_cracks(rows, 1, fmt::format("watertight (Woop), {}", where), others[0], others[1]);
    add_cracks(rows, 1, fmt::format("edge functions alone fused, {}", where), others[2], others[1]);
  }
  return rows;
}

constexpr int book_side = 600;

std::vector<std::uint8_t> picture_of(const FlagBuild& build, const StabilityRun& run) {
  run.check();
  std::vector<std::uint8_t> pixels(3 * book_side * book_side);
  build.book_picture(book_side, pixels.data());
  return pixels;
}

struct PixelDifference {
  double pixels = 0;   ///< that differ
  double largest = 0;  ///< levels
};

PixelDifference difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  PixelDifference result;
  for (std::size_t i = 0; i < a.size(); i += 3) {
    int worst = 0;
    for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(a[i + c] - b[i + c]));
    result.pixels += worst > 0 ? 1 : 0;
    result.largest = std::max(result.largest, static_cast<double>(worst));
  }
  return result;
}

std::vector<StabilityRow> measure_flags(const StabilityRun& run) {
  const std::vector<std::uint8_t> plain = picture_of(plain_build(), run);
  PixelDifference same{std::nan(""), std::nan("")};
  Rows rows(run);
  int knob = 0;
  for (const FlagBuild& build : {unoptimised_build(), contracted_build(), fast_build(), fast_contracted_build(),
                                 x87_build(), uncontracted_build()}) {
    ++knob;
    if (!build.available()) continue;
    const PixelDifference other = difference(plain, picture_of(build, run));
    // What the program promises: the same pixels whatever the optimisation, as long as nothing may be fused.
    if (knob == 1) same = other;
    const double at = knob;
    rows.push_back({at, build.name, other.pixels, same.pixels, "px of 360,000 differ"});
    rows.push_back({at, build.name + std::string(", largest difference"), other.largest, same.largest, "levels"});
  }
  return rows;
}

}  // namespace

static constexpr KnobCase fma_contraction_cases[]{{0, "products rounded"}, {1, "products fused"}};
static constexpr StabilitySeries fma_contraction_series[]{
    {.names = "watertight (Woop)|Moeller-Trumbore|*",
     .title = "rays that slip through",
     .unit = "per million",
     .cases = fma_contraction_cases},
    {.names = "*double hits", .title = "rays that hit two triangles", .unit = "per million"},
};

extern const StabilityExperiment fma_contraction{
    .key = "fma-contraction",
    .place = {Subject::rays, 130},
    .set_up = SetUp::reproduction,
    .title = "FMA contraction: fused multiply-add",
    .keywords = "FMA, fused multiply-add, compiler, reproducible, rounding",
    .knob = "how the compiler rounds products",
    .naive = "-mfma -ffp-contract=fast",
    .robust = "-ffp-contract=off",
    .explanation =
        "The watertight test relies on a b - c d being the exact opposite of c d - a b. Fused, one of the two "
        "products is not rounded, and which one it is depends on the order.",
    .safe = "Without contraction, or where the products are compared or subtracted by Kahan's method.",
    .window = {0, 0},
    .series = fma_contraction_series,
    .measure = measure_contraction};

static constexpr StabilitySeries build_flags_series[]{
    {.names = "*", .title = "pixels that differ from a build without the flags", .unit = "px of 360,000"},
    {.names = "*, largest difference", .title = "largest difference", .unit = "levels of 255"},
};

extern const StabilityExperiment build_flags{
    .key = "build-flags",
    .place = {Subject::numbers, 70},
    .set_up = SetUp::reproduction,
    .title = "Flags of the compiler",
    .keywords = "fast-math, compiler flags, optimisation, optimization, x87, reproducible",
    .knob = "flags of the compiler",
    .naive = "the book's scene in float with other flags",
    .robust = "-ffp-contract=off at any optimisation",
    .explanation = "Flags that let the compiler fuse or reorder sums change roundings, and where a mirrored ray grazes "
                   "the ground one rounding decides what it meets. Optimisation alone changes nothing.",
    .safe = "-O0 to -O3 without contraction.",
    .window = {1, 1},
    .series = build_flags_series,
    .measure = measure_flags};

}  // namespace ps::stability::build_flags
