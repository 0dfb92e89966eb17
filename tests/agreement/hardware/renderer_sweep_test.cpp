// The renderers compared: the hardware renderer's time is that of its draw calls, its upload is apart, and where there
// is no driver the sweep says so.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "agreement/hardware/hardware_pair.h"
#include "base/atomic_file.h"
#include "frame/display_frame.h"
#include "hardware/gl_thread.h"
#include "image/file.h"
#include "options/renderer_kind.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "study/chart.h"
#include "study/chart_log.h"
#include "study/renderer_sweep.h"
#include "support/emulated.h"
#include "support/environment.h"
#include "support/render_once.h"
#include "support/run_cli.h"
#include "support/settings_with.h"

namespace ps::renderer_sweep_test {
namespace {

ChartRequest all_renderers(const std::string& scene) {
  const std::vector<SweepAxis> axes = parse_sweep(renderer_sweep);
  ChartRequest request;
  request.scene = load_scene(scene);
  request.view = {request.scene.camera, 40, 25};
  request.base = settings_for(request.scene);
  request.points = sweep_points(axes, request.base, request.base, scene_traits(request.scene));
  request.absent = absent_renderers(axes);
  request.repeats = 3;
  request.shortest_sample = 0;
  return request;
}

/// A clock on which every look takes half a second: wall time is 500 ms, whatever is measured.
Clock slow_clock() {
  return [now = 0.0]() mutable { return now += 0.5; };
}

TEST(RendererSweep, HardwareIsTimedByItsDrawCallsWithTheUploadApart) {
  PS_NEEDS_HARDWARE(hardware);
  const test::ScratchFolder folder;
  ChartRequest request = all_renderers("cgpp/teapot");
  request.folder = folder.path() / "chart";
  StudyControl control;
  const Chart chart = run_chart(request, control, {}, slow_clock());
  ASSERT_EQ(chart.points.size(), 3u);
  EXPECT_TRUE(chart.absent.empty());
  for (const ChartPoint& point : chart.points) {
    ASSERT_EQ(point.samples_ms.size(), 3u);
    const bool by_driver = point.what.value.renderer == hardware;
    for (const double sample : point.samples_ms) {
      if (by_driver)
        EXPECT_NE(sample, 500) << "the driver's own time, not that of the clock around it";
      else
        EXPECT_EQ(sample, 500) << point.what.label;
    }
    EXPECT_EQ(point.uploads_ms.size(), by_driver ? 3u : 0u);
    EXPECT_EQ(point.upload_ms.has_value(), by_driver);
  }
  // The folder holds both.
  const Chart kept = read_chart_log(request.folder);
  for (std::size_t i = 0; i < chart.points.size(); ++i) {
    EXPECT_EQ(kept.points[i].samples_ms, chart.points[i].samples_ms);
    EXPECT_EQ(kept.points[i].uploads_ms, chart.points[i].uploads_ms);
  }
}

TEST(RendererSweep, AnEmptiedDriverUploadsTheWholeSceneAndDrawsTheSame) {
  PS_NEEDS_HARDWARE(hardware);
  const Scene teapot = load_scene("cgpp/teapot"), other = load_scene("cgpp/ground");
  const auto draw = [&](const Scene& scene, DriverMemory memory) {
    Settings settings = settings_for(scene, hardware);
    RenderRequest request;
    request.driver_memory = memory;
    return render(scene, {scene.camera, 40, 25}, settings, request);
  };
  const auto meshes = [] {
    std::size_t count = 0;
    hardware::on_gl_thread([&](hardware::Workshop& shop) { count = shop.meshes.size(); });
    return count;
  };
  draw(other, DriverMemory::emptied);
  const std::size_t of_other = meshes();
  const Frame first = draw(teapot, DriverMemory::kept);
  const std::size_t of_both = meshes();
  EXPECT_GT(of_both, of_other) << "those of the other scene are kept";
  const Frame again = draw(teapot, DriverMemory::emptied);
  const std::size_t of_teapot = meshes();
  EXPECT_GT(of_teapot, 0u);
  EXPECT_LT(of_teapot, of_both) << "the other scene's are dropped";
  draw(other, DriverMemory::kept);
  EXPECT_GT(meshes(), of_teapot);
  EXPECT_EQ(first.colour, again.colour);
}

TEST(RendererSweep, SaysWhyHardwareIsAbsentWithoutADriver) {
  if (test::is_emulated()) GTEST_SKIP() << "the emulator has no libraries of OpenGL";
  PS_NEEDS_HARDWARE(hardware);
  const test::ScratchFolder folder;
  const test::WithoutEglDriver without(folder.path().string());
  const std::string out = folder.file("chart");
  const auto result = test::run_cli_well(
      {"chart", "cgpp/triangle", "--size", "16x10", "--sweep", "renderers", "--repeats", "1", "--out", out});
  EXPECT_NE(result.out.find("Not drawn: hardware (OpenGL): no OpenGL: no driver"), std::string::npos) << result.out;
  const auto json = nlohmann::json::parse(read_whole_file(out + "/points.json"));
  ASSERT_EQ(json.at("points").size(), 2u);
  EXPECT_EQ(json.at("absent").size(), 1u);
  for (const auto& point : json.at("points")) EXPECT_NE(point.at("renderer"), "hardware");
}

TEST(RendererSweep, OneCommandDrawsTheThreeScenesOfTheBookWithAllThree) {
  PS_NEEDS_HARDWARE(hardware);
  const test::ScratchFolder folder;
  const std::string sheet = folder.file("sheet.png");
  test::run_cli_well({"renderers", "--size", "40x25", "--repeats", "1", "--sheet", sheet});
  const Image<Rgb8> picture = load_levels(sheet);
  constexpr int gap = 6;
  ASSERT_EQ(picture.width(), 3 * 40 + 2 * gap);
  ASSERT_EQ(picture.height(), 3 * 25 + 2 * gap);
  int row = 0;
  for (const char* name : {"cgpp/triangle", "cgpp/ground", "cgpp/teapot"}) {
    const Scene scene = load_scene(name);
    int column = 0;
    for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer, hardware}) {
      Settings settings = settings_for(scene, renderer);
      if (renderer != Renderer::ray_tracer) settings.shadows = Shadows::map;
      const View view{scene.camera, 40, 25};
      const Image<Rgb8> wanted = display_frame(render(scene, view, settings), settings);
      for (int y = 0; y < 25; ++y)
        for (int x = 0; x < 40; ++x)
          ASSERT_EQ(picture.at(column * (40 + gap) + x, row * (25 + gap) + y), wanted.at(x, y))
              << name << " " << renderer_label(renderer) << " " << x << "," << y;
      ++column;
    }
    ++row;
  }
}

}  // namespace
}  // namespace ps::renderer_sweep_test
