// The sweep of renderers and the upload beside it, without a driver: what charts, their files and sheets make of both.
#include "study/renderer_sweep.h"

#include <gtest/gtest.h>

#include "base/check.h"
#include "options/renderer_kind.h"
#include "study/chart_files.h"
#include "study/chart_log_lines.h"
#include "study/chart_style.h"
#include "study/picture_sheet.h"

namespace ps::renderer_sweep_unit_test {
namespace {

/// Two points, the second with uploads of 10, 30 and 20 ms beside draws of 2, 1 and 3.
Chart chart_with_upload(ChartAcross across) {
  Chart chart;
  chart.across = across;
  chart.identity.points = 2;
  for (int i = 0; i < 2; ++i) {
    ChartPoint point;
    point.number = i;
    point.what.label = point.what.name = i == 0 ? "own" : "driver's";
    point.what.value.renderer = i == 0 ? Renderer::ray_tracer : Renderer::rasterizer;
    point.samples_ms = i == 0 ? std::vector<double>{5, 6, 7} : std::vector<double>{2, 1, 3};
    if (i == 1) point.uploads_ms = {10, 30, 20};
    point.comparison.rmse = 3.0 - i;
    point.compared = true;
    point.work = 100;
    chart.points.push_back(point);
  }
  summarise(chart, ErrorMetric::rmse);
  return chart;
}

TEST(RendererSweep, LacksWhatThisProgramWasBuiltWithout) {
  const std::vector<SweepAxis> axes = parse_sweep(renderer_sweep);
  ASSERT_EQ(axes.size(), 1u);
  EXPECT_EQ(axes[0].values, (std::vector<std::string>{"ray-tracer", "rasterizer"})) << "no listing, no driver";
  EXPECT_EQ(absent_renderers(axes),
            std::vector<std::string>{"graphics driver: this program was built without a renderer that uses it"});
  EXPECT_TRUE(absent_renderers(parse_sweep("renderer=ray-tracer")).empty()) << "nobody asked for all of them";
  EXPECT_TRUE(absent_renderers(parse_sweep("samples")).empty());
}

TEST(RendererSweep, UploadIsBesideTheTimeAndNotInIt) {
  const Chart chart = chart_with_upload(ChartAcross::time);
  const ChartPoint &own = chart.points[0], &driver = chart.points[1];
  EXPECT_EQ(driver.time_ms.median, 2);
  EXPECT_EQ(driver.cost.median, 2) << "the point lies at the draw";
  ASSERT_TRUE(driver.upload_ms);
  EXPECT_EQ(driver.upload_ms->median, 20);
  EXPECT_EQ(cost_with_upload(chart, driver), 22);
  EXPECT_FALSE(own.upload_ms);
  EXPECT_FALSE(cost_with_upload(chart, own));
  EXPECT_GE(chart_axes(chart).cost.high, 22) << "the bar ends on the plot";
  EXPECT_FALSE(cost_with_upload(chart_with_upload(ChartAcross::work), driver)) << "work has no upload";
  EXPECT_NE(chart_provenance(chart).find("Upload of the scene, apart: 20 ms for driver's."), std::string::npos);
}

TEST(RendererSweep, FilesHaveTheUploadInAPlaceOfItsOwn) {
  const Chart chart = chart_with_upload(ChartAcross::time);
  const std::string csv = chart_csv(chart);
  EXPECT_NE(csv.find(",upload_ms,"), std::string::npos);
  EXPECT_TRUE(csv.ends_with(",20,compared,\n")) << csv;
  EXPECT_NE(chart_svg(chart).find("with upload"), std::string::npos);
  EXPECT_EQ(chart_svg(chart_with_upload(ChartAcross::work)).find("with upload"), std::string::npos);
}

TEST(RendererSweep, LogLinesKeepAnUpload) {
  Chart chart = chart_with_upload(ChartAcross::time);
  const ChartSample with = chart_sample_from(chart_sample_json(chart.points[1], 3), 2);
  EXPECT_EQ(with.milliseconds, 3);
  EXPECT_EQ(with.upload_ms, 20) << "the last";
  EXPECT_FALSE(chart_sample_from(chart_sample_json(chart.points[0], 3), 2).upload_ms);
  nlohmann::ordered_json bad = chart_sample_json(chart.points[1], 3);
  bad["upload_ms"] = -1;
  EXPECT_THROW(chart_sample_from(bad, 2), InputError);
  chart.absent = {"hardware: no OpenGL"};
  Chart again;
  chart.identity.width = chart.identity.height = 1;
  read_chart_head(chart_head_json(chart), again);
  EXPECT_EQ(again.absent, chart.absent);
}

TEST(RendererSweep, EachRendererHasAMarkOfItsOwn) {
  EXPECT_EQ(mark_shape(Renderer::ray_tracer), MarkShape::circle);
  EXPECT_EQ(mark_shape(Renderer::rasterizer), MarkShape::square);
  EXPECT_EQ(mark_shape(Renderer::textbook), MarkShape::triangle);
}

TEST(PictureSheet, PutsEachPictureIntoItsPlace) {
  const auto plain = [](int width, int height, std::uint8_t level) {
    return Image<Rgb8>(width, height, Rgb8{level, level, level});
  };
  const std::vector<std::vector<Image<Rgb8>>> rows{{plain(4, 3, 10), plain(2, 2, 20)}, {plain(4, 3, 30)}};
  const Image<Rgb8> sheet = picture_sheet(rows);
  ASSERT_EQ(sheet.width(), 4 + 6 + 4);
  ASSERT_EQ(sheet.height(), 3 + 6 + 3);
  EXPECT_EQ(sheet.at(3, 2).r, 10);
  EXPECT_EQ(sheet.at(4, 2).r, 255) << "between two places";
  EXPECT_EQ(sheet.at(10, 0).r, 20);
  EXPECT_EQ(sheet.at(12, 0).r, 255) << "a smaller picture leaves the rest white";
  EXPECT_EQ(sheet.at(0, 9).r, 30);
  EXPECT_EQ(sheet.at(10, 9).r, 255) << "no picture there";
  EXPECT_TRUE(picture_sheet({}).empty());
}

}  // namespace
}  // namespace ps::renderer_sweep_unit_test
