// The number beside the difference of A and B.
#include "gui/work/difference_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "frame/display_frame.h"
#include "gui/program.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/golden.h"

namespace ps::gui::difference_meter_test {
namespace {

/// Both pictures as the renderer makes them without a window.
Image<Rgb8> drawn(const std::string& assignment) {
  const Scene scene = load_scene("cgfs/shading");
  Settings settings = settings_for(scene);
  parse_assignment("renderer=rasterizer", settings);
  parse_assignment(assignment, settings);
  return display_frame(render(scene, {scene.camera, 90, 60}, settings), settings);
}

TEST(DifferenceMeter, TheWindowShowsTheMetricOfItsPictures) {
  const Image<Rgb8> a = drawn("shading=flat"), b = drawn("shading=phong");
  double squared = 0, largest = 0, count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      for (const int d : {a.at(x, y).r - b.at(x, y).r, a.at(x, y).g - b.at(x, y).g, a.at(x, y).b - b.at(x, y).b}) {
        squared += d * d;
        largest = std::max<double>(largest, std::abs(d));
        ++count;
      }
  ASSERT_GT(largest, 0);
  const auto folder = fresh_output_folder("gui-difference-meter");
  const auto result = test::play(
      "wait idle\nset renderer=rasterizer\nset-b renderer=rasterizer\nset shading=flat\nset-b shading=phong\n"
      "key D\nwait idle\nprint difference/measured\nexpect difference/error contains \"levels of 255\"\n"
      "choose difference/metric max\nwait idle\nprint difference/measured\n"
      "choose difference/metric flip\nwait idle\nprint difference/measured\n"
      "choose difference/metric psnr\nset shading=phong\nwait idle\nexpect difference/error \"infinite: no level "
      "differs\"\n",
      folder, "1366x768", "cgfs/shading --size 90x60");
  ASSERT_EQ(result.status, 0) << result.errors;
  std::istringstream lines(result.output);
  double rmse = 0, max = 0, flip = 0;
  ASSERT_TRUE(lines >> rmse >> max >> flip) << result.output;
  EXPECT_NEAR(rmse, std::sqrt(squared / count), 1e-12);
  EXPECT_EQ(max, largest);
  EXPECT_GT(flip, 0);
  EXPECT_LT(flip, 1);
}

TEST(DifferenceMeter, ValuesHaveTheirUnit) {
  EXPECT_EQ(difference_text(ErrorMetric::rmse, 12.3456), "12.35 levels of 255");
  EXPECT_EQ(difference_text(ErrorMetric::max, 255), "255 levels of 255");
  EXPECT_EQ(difference_text(ErrorMetric::psnr, 31.41), "31.41 dB");
  EXPECT_EQ(difference_text(ErrorMetric::flip, 0), "0.0000 (0 = equal)");
  for (const ErrorMetricRow& row : error_metrics()) EXPECT_NE(std::string(metric_help(row.metric)), "");
}

}  // namespace
}  // namespace ps::gui::difference_meter_test
