#include <algorithm>
#include <cmath>

#include "image/display.h"
#include "image/metrics.h"
#include "image/mixing.h"
#include "study/stability/support.h"

namespace ps::stability::nan_in_a_picture {
namespace {

constexpr double limit = 0.01;  ///< of the error that a check of pictures lets pass
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

enum class Middle { number, not_a_number };
enum class Sums { all, finite };  ///< what they take in

/// Random greys; the pixel in the middle is NaN if asked for.
constexpr int side = 64, middle = side / 2;
Image<Vec3f> greys(Middle pixel_there, const StabilityRun& run) {
  Random random(run.seed);
  Image<Vec3f> picture(side, side);
  for (Vec3f& pixel : picture.pixels()) pixel = Vec3f(static_cast<float>(random.unit()));
  if (pixel_there == Middle::not_a_number) picture.at(middle, middle) = Vec3f(nan);
  return picture;
}

/// What clamping leaves of the NaN pixel; other pixels lie between 0 and 1 and stay.
template <class Clamp>
Image<Vec3f> clamped(Image<Vec3f> picture, Clamp&& clamp) {
  for (Vec3f& pixel : picture.pixels()) pixel = {clamp(pixel.r), clamp(pixel.g), clamp(pixel.b)};
  return picture;
}

void add_clamps(Rows& rows, const StabilityRun& run) {
  const Image<Vec3f> picture = greys(Middle::not_a_number, run);
  Image<Vec3f> robust = picture;
  for (Vec3f& pixel : robust.pixels()) pixel = clamp_colour(pixel);
  const auto add = [&](const std::string& how, const Image<Vec3f>& naive) {
    rows.add(0, "NaN left by " + how, static_cast<double>(count_nan_pixels(naive)),
             static_cast<double>(count_nan_pixels(robust)), "pixels");
  };
  add("std::clamp(x, 0, 1)", clamped(picture, [](float x) { return std::clamp(x, 0.0f, 1.0f); }));
  add("min(max(x, 0), 1)", clamped(picture, [](float x) { return std::min(std::max(x, 0.0f), 1.0f); }));
  const Image<Vec3f> inside_out = clamped(picture, [](float x) { return std::max(0.0f, std::min(1.0f, x)); });
  add("max(0, min(1, x))", inside_out);
  rows.add(0, "value of the NaN pixel after max(0, min(1, x))", static_cast<double>(inside_out.at(middle, middle).r),
           static_cast<double>(robust.at(middle, middle).r), "linear");
}

/// Root of the mean square over all channels, as it is often written.
double plain_rmse(const Image<Vec3f>& a, const Image<Vec3f>& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Vec3d error = Vec3d(a.pixels()[i]) - Vec3d(b.pixels()[i]);
    squares += dot(error, error);
  }
  return std::sqrt(squares / (3.0 * static_cast<double>(a.pixels().size())));
}

void add_checks(Rows& rows, const StabilityRun& run) {
  const Image<Vec3f> right = greys(Middle::number, run), wrong = greys(Middle::not_a_number, run);
  const auto add = [&](const char* series, const Image<Vec3f>& picture) {
    const double rmse = plain_rmse(picture, right);
    rows.add(0, series, rmse > limit ? 0.0 : 1.0, rmse <= limit ? 1.0 : 0.0, "passed");
  };
  add("check of the error, a NaN in the picture", wrong);
  add("check of the error, the right picture", right);
  // The program's own comparison leaves such pixels out of its means, so their number belongs into every check.
  const Comparison comparison = compare_channels(wrong, right);
  rows.add(0, "not finite, counted before the error", std::nan(""), static_cast<double>(comparison.not_finite),
           "pixels");
}

/// Means of `width` x `width` pixels; the robust ones are of the pixels that are finite.
double lost_to_blur(const Image<Vec3f>& picture, int width, Sums sums) {
  const int reach = width / 2;
  double lost = 0;
  for (int y = reach; y < side - reach; ++y)
    for (int x = reach; x < side - reach; ++x) {
      float sum = 0, taken = 0;
      for (int v = y - reach; v <= y + reach; ++v)
        for (int u = x - reach; u <= x + reach; ++u) {
          const float grey = picture.at(u, v).r;
          if (sums == Sums::finite && !std::isfinite(grey)) continue;
          sum += grey;
          ++taken;
        }
      const float mean = sums == Sums::finite && taken == 0 ? 0.0f : sum / taken;
      lost += std::isnan(mean) ? 1 : 0;
    }
  return lost;
}

/// Means along the row of the NaN pixel from a sum that takes one pixel in and lets one go. Percentage that is NaN of
/// those behind the window's first touch, to the row's end.
double lost_to_running_sum(const Image<Vec3f>& picture, int width, Sums sums) {
  const auto row = picture.row(middle);
  const auto value = [&](int x) {
    const float grey = row[static_cast<std::size_t>(x)].r;
    return sums == Sums::finite && !std::isfinite(grey) ? 0.0f : grey;
  };
  float sum = 0;
  double lost = 0, later = 0;
  for (int x = 0; x < side; ++x) {
    sum += value(x);
    if (x >= width) sum -= value(x - width);
    if (x < middle) continue;
    ++later;
    lost += std::isnan(sum / static_cast<float>(width)) ? 1 : 0;
  }
  return percent(lost, later);
}

/// A pixel's mean of 256 samples, taken in one after another, of which the 17th is NaN: percentage that is NaN of the
/// means from there on.
double lost_to_samples(Sums sums, const StabilityRun& run) {
  constexpr int samples = 256, bad = 16;
  Random random(run.seed);
  float mean = 0;
  double taken = 0, lost = 0;
  for (int i = 0; i < samples; ++i) {
    const float sample = i == bad ? nan : static_cast<float>(random.unit());
    if (sums == Sums::all || std::isfinite(sample)) mean += (sample - mean) / static_cast<float>(++taken);
    if (i >= bad) lost += std::isnan(mean) ? 1 : 0;
  }
  return percent(lost, samples - bad);
}

void measure(const StabilityRun& run, Rows& rows) {
  const Image<Vec3f> picture = greys(Middle::not_a_number, run);
  for (const int width : {1, 3, 5, 9, 15})
    rows.add(width, "blur, one NaN pixel", lost_to_blur(picture, width, Sums::all),
             lost_to_blur(picture, width, Sums::finite), "pixels lost");
  for (const int width : {3, 5, 9, 15})
    rows.add(width, "blur by a running sum", lost_to_running_sum(picture, width, Sums::all),
             lost_to_running_sum(picture, width, Sums::finite), "% of later means lost");
  rows.add(0, "running mean of samples", lost_to_samples(Sums::all, run), lost_to_samples(Sums::finite, run),
           "% of later means lost");
  add_clamps(rows, run);
  add_checks(rows, run);
}

}  // namespace

extern const StabilityExperiment nan_in_a_picture{
    .key = "nan-in-a-picture",
    .place = {Subject::numbers, 60},
    .set_up = SetUp::reproduction,
    .title = "A NaN in a picture",
    .keywords = "not a number, metric, RMSE, comparison",
    .knob = "width of the blur in pixels, 0 = none",
    .naive = "treat it as any number",
    .robust = "test for valid values, count those that are not finite",
    .explanation = "A sum with a NaN is NaN, so one pixel spoils all means around it and all later values of a running "
                   "sum. Every comparison with NaN is false: clamping returns NaN or 1, depending on the order of its "
                   "operands, and an error of NaN is not above the limit.",
    .safe = "No NaN.",
    .window = nowhere_safe,
    .series =
        {{.names = "blur, one NaN pixel",
          .title = "pixels lost around one NaN",
          .unit = "px",
          .between = Between::nothing},
         {.names = "blur by a running sum",
          .title = "later means that are lost",
          .unit = "%",
          .between = Between::nothing},
         {.names = "running mean of samples", .title = "later means that are lost", .unit = "%"},
         {.names = "NaN left*", .title = "NaN pixels that are left", .unit = "px"},
         {.names = "value of*", .title = "value of the NaN pixel", .unit = "linear light", .better = Better::neither},
         {.names = "check of the error, a NaN in the picture",
          .title = "checks passed by a picture with a NaN",
          .unit = "checks"},
         {.names = "check of the error, the right picture",
          .title = "checks passed by the right picture",
          .unit = "checks",
          .better = Better::higher},
         {.names = "not finite*", .title = "values reported as not finite", .unit = "px", .better = Better::higher}},
    .add_rows = measure};

}  // namespace ps::stability::nan_in_a_picture
