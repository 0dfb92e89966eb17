#include "base/enumerators.h"
#include "study/chart.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/check.h"
#include "frame/display_frame.h"
#include "image/display.h"
#include "image/file.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "options/simd_choice.h"
#include "scene/load.h"
#include "study/chart_conclusion.h"
#include "study/chart_files.h"
#include "study/chart_style.h"
#include "support/run_cli.h"
#include "support/seeded_random.h"
#include "support/trials.h"

namespace ps::chart_test {
namespace {

ChartRequest small_request(const std::string& scene_name = "cgfs/reflections") {
  ChartRequest request;
  request.scene = load_scene(scene_name);
  request.view = {request.scene.camera, 40, 30};
  request.base = settings_for(request.scene);
  const std::vector<SweepAxis> axes{parse_sweep_axis("reflection-depth=0,1,3"), parse_sweep_axis("precision")};
  request.points = sweep_points(axes, request.base, request.base, scene_traits(request.scene));
  request.repeats = 3;
  request.shortest_sample = 0;
  return request;
}

/// Numbers, errors, memory and counters: everything but times.
void expect_same_but_times(const Chart& a, const Chart& b) {
  EXPECT_TRUE(a.identity == b.identity);
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const ChartPoint &p = a.points[i], &q = b.points[i];
    EXPECT_EQ(p.number, q.number);
    EXPECT_EQ(p.what.label, q.what.label);
    EXPECT_EQ(p.what.settings, q.what.settings);
    EXPECT_EQ(p.what.value, q.what.value);
    EXPECT_EQ(p.error, q.error);
    EXPECT_EQ(p.comparison.flip, q.comparison.flip);
    EXPECT_EQ(p.comparison.psnr, q.comparison.psnr);
    EXPECT_EQ(p.memory_mb, q.memory_mb);
    EXPECT_EQ(p.counters, q.counters);
    EXPECT_EQ(*p.picture, *q.picture);
    EXPECT_EQ(p.samples_ms.size(), q.samples_ms.size());
  }
}

TEST(Chart, ErrorIsWhatCompareSaysOfThePicturesInTheFolder) {
  const test::ScratchFolder scratch;
  for (const ErrorMetricRow& metric : error_metrics()) {
    ChartRequest request = small_request();
    request.folder = scratch.path() / "chart";
    request.error.metric = metric.metric;
    StudyControl control;
    const Chart chart = run_chart(request, control);
    const auto reference = load_levels(request.folder / "reference.png");
    for (const ChartPoint& point : chart.points) {
      const auto picture = load_levels(request.folder / ("picture-" + std::to_string(point.number) + ".png"));
      EXPECT_EQ(picture, display_frame(render(request.scene, request.view, point.what.value), point.what.value));
      EXPECT_EQ(point.error, error_of(compare_images(reference, picture), metric.metric)) << metric.key;
    }
  }
}

TEST(Chart, ShardsMergedEqualTheWhole) {
  const test::ScratchFolder scratch;
  StudyControl control;
  ChartRequest request = small_request();
  const Chart whole = run_chart(request, control);
  ASSERT_EQ(whole.points.size(), 6u);
  std::vector<std::filesystem::path> folders;
  std::size_t sum = 0;
  for (const char* shard : {"1/4", "2/4", "3/4", "4/4"}) {
    request.shard = parse_shard(shard);
    request.folder = folders.emplace_back(scratch.path() / std::to_string(folders.size()));
    sum += run_chart(request, control).points.size();
  }
  EXPECT_EQ(sum, whole.points.size());
  expect_same_but_times(merge_charts(folders, request.error.metric), whole);
  ChartRequest other = small_request();
  other.view.width = 41;
  other.folder = scratch.path() / "other";
  run_chart(other, control);
  EXPECT_THROW(merge_charts({folders[0], other.folder}, ErrorMetric::rmse), InputError);
  EXPECT_THROW(merge_charts({scratch.path() / "none"}, ErrorMetric::rmse), InputError);
}

TEST(Chart, TheReferenceTakesMoreSamplesThanAnyPoint) {
  const auto samples = [](std::initializer_list<int> of_points, int side = 64) {
    std::vector<SweepPoint> points;
    for (const int samples_per_pixel : of_points) {
      points.emplace_back();
      points.back().value.samples_per_pixel = samples_per_pixel;
    }
    return plan_reference(points, {}, {}, {{}, side, side}, {}).samples;
  };
  EXPECT_EQ(samples({}), 1) << "nothing estimates an average";
  EXPECT_EQ(samples({1}), 1);
  EXPECT_EQ(samples({1, 4}), 64) << "as many as are cheap";
  EXPECT_EQ(samples({1, 4}, 2000), 16) << "but no more than needed where they are not";
  EXPECT_EQ(samples({5, 1}, 2000), 64);
  EXPECT_EQ(samples({1, 16, 4}), 64);
  EXPECT_EQ(samples({64, 1}, 600), 256);
  EXPECT_EQ(samples({4096, 1}, 600), 4096) << "no more than the option allows";
}

TEST(Chart, ShardTextCountsFromOneOrFromZero) {
  EXPECT_EQ(parse_shard("2/4").index, 2);
  EXPECT_EQ(parse_shard("4/4").index, 0);
  EXPECT_EQ(parse_shard("0/4").index, 0);
  for (const char* text : {"", "1", "5/4", "-1/4", "1/0", "1/4x", "a/b", "/"})
    EXPECT_THROW(parse_shard(text), InputError) << text;
}

TEST(Chart, CancelledChartsAreTakenUpWhereTheyStopped) {
  const test::ScratchFolder scratch;
  ChartRequest request = small_request();
  StudyControl straight;
  const Chart whole = run_chart(request, straight);
  request.folder = scratch.path();
  StudyControl stopped;
  const auto stop_after_five = [&](const Chart&, const StudyStatus& status) {
    if (status.done == 5) stopped.cancel();
  };
  EXPECT_THROW(run_chart(request, stopped, stop_after_five), Cancelled);
  std::ofstream(scratch.file("runs.jsonl"), std::ios::app)
      << "{\"sample\":0,\"time_";  // a crash in the middle of a line
  StudyControl resumed;
  int first_done = -1, runs = 0;
  const Chart chart = run_chart(request, resumed, [&](const Chart&, const StudyStatus& status) {
    if (first_done < 0)
      first_done = status.done;
    else
      ++runs;
  });
  EXPECT_EQ(first_done, 5);
  EXPECT_EQ(runs, 6 * 3 - 5);
  expect_same_but_times(chart, whole);
  expect_same_but_times(merge_charts({scratch.path()}, ErrorMetric::rmse), whole);
}

TEST(Chart, AFolderOfAnotherChartIsNotOverwritten) {
  const test::ScratchFolder scratch;
  ChartRequest request = small_request();
  request.folder = scratch.path();
  StudyControl control;
  run_chart(request, control);
  const std::string before = read_whole_file(scratch.file("runs.jsonl"));
  request.view.width = 44;
  EXPECT_THROW(run_chart(request, control), InputError);
  EXPECT_EQ(read_whole_file(scratch.file("runs.jsonl")), before);
  ChartRequest other_view = small_request();
  other_view.view.camera.position.x += 1;
  other_view.folder = scratch.path();
  EXPECT_THROW(run_chart(other_view, control), InputError);
  ChartRequest edited = small_request();
  std::vector<Material> materials = *edited.scene.materials;
  materials[0].colour = {0, 1, 1};
  edited.scene.materials = Part<std::vector<Material>>(std::move(materials));
  edited.folder = scratch.path();
  EXPECT_THROW(run_chart(edited, control), InputError);
  EXPECT_EQ(read_whole_file(scratch.file("runs.jsonl")), before);
  ChartRequest other_sweep = small_request();
  std::reverse(other_sweep.points.begin(), other_sweep.points.end());
  other_sweep.folder = scratch.path();
  EXPECT_THROW(run_chart(other_sweep, control), InputError);
  EXPECT_EQ(read_whole_file(scratch.file("runs.jsonl")), before);
}

TEST(Chart, RepeatsAreInterleavedAndQuartilesAreThoseOfTheSamples) {
  ChartRequest request = small_request();
  request.repeats = 4;
  double now = 0;
  const Clock clock = [&] { return now += 0.5; };  // every reading half a second later than the last
  StudyControl control;
  const Chart chart = run_chart(
      request, control,
      [&](const Chart& c, const StudyStatus&) {
        const auto [low, high] =
            std::minmax_element(c.points.begin(), c.points.end(), [](const ChartPoint& a, const ChartPoint& b) {
              return a.samples_ms.size() < b.samples_ms.size();
            });
        EXPECT_LE(high->samples_ms.size() - low->samples_ms.size(), 1u);
      },
      clock);
  for (const ChartPoint& point : chart.points) {
    EXPECT_EQ(point.samples_ms, std::vector<double>(4, 500));
    EXPECT_EQ(point.time_ms.median, 500);
  }
}

TEST(Chart, CancellingEndsAPauseAndTheChart) {
  ChartRequest request = small_request();
  StudyControl control;
  control.set_paused(true);
  int updates = 0;
  EXPECT_TRUE(control.paused());
  control.cancel();  // also ends the pause
  EXPECT_FALSE(control.paused());
  EXPECT_THROW(run_chart(request, control, [&](const Chart&, const StudyStatus&) { ++updates; }), Cancelled);
  EXPECT_EQ(updates, 0);
}

TEST(Chart, RegionAndValuesDecideWhatIsCompared) {
  ChartRequest request = small_request();
  request.error.region = TileRect{5, 6, 25, 20};
  request.error.values = ErrorValues::linear;
  StudyControl control;
  const Chart chart = run_chart(request, control);
  Settings best = request.base;
  best.reflection_depth = 64;
  best.precision = Precision::float64;
  best.sphere_test = SphereTest::robust;
  const Frame reference = render(request.scene, request.view, best);
  for (const ChartPoint& point : chart.points) {
    const Frame frame = render(request.scene, request.view, point.what.value);
    double sum = 0;
    for (int y = 6; y < 20; ++y)
      for (int x = 5; x < 25; ++x)
        for (int c = 0; c < 3; ++c) {
          const double d =
              static_cast<double>(frame.colour.at(x, y)[c]) - static_cast<double>(reference.colour.at(x, y)[c]);
          sum += d * d;
        }
    EXPECT_NEAR(point.error, std::sqrt(sum / (20 * 14 * 3)), 1e-12) << point.what.label;
  }
  request.error.region = TileRect{30, 0, 50, 10};
  EXPECT_THROW(run_chart(request, control), InputError);
}

TEST(Chart, FilesHoldTheTableOfTheDesign) {
  ChartRequest request = small_request();
  StudyControl control;
  const Chart chart = run_chart(request, control);
  const std::string csv = chart_csv(chart);
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "label,renderer,settings,time_ms,time_q1_ms,time_q3_ms,error,memory_mb,on_front,work,machinery,truth,"
            "program,processor,simd,threads,base_settings,tie,upload_ms,standing,left_out");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);
  const std::string svg = chart_svg(chart);
  std::size_t circles = 0;
  for (std::size_t at = svg.find("<circle"); at != std::string::npos; at = svg.find("<circle", at + 1)) ++circles;
  EXPECT_EQ(circles, 10u) << "six points; in the legend both precisions and two sizes";
  EXPECT_NE(chart_json(chart).find("\"processor\""), std::string::npos);
  const auto json = nlohmann::json::parse(chart_json(chart));
  EXPECT_EQ(json.at("conclusion"), chart_conclusion(chart).sentence);
  EXPECT_NE(json.at("conclusion"), "");
  EXPECT_EQ(json.at("points").at(0).at("tie"), chart.points[0].tie);
}

Chart swept_chart(const std::string& scene, const std::vector<std::string>& sweeps,
                  const std::vector<std::string>& assignments = {}, MachineryRule rule = MachineryRule::same) {
  ChartRequest request;
  request.scene = load_scene(scene);
  request.view = {request.scene.camera, test::side(80), test::side(60)};
  request.base = settings_for(request.scene);
  for (const std::string& assignment : assignments) parse_assignment(assignment, request.base);
  std::vector<SweepAxis> axes;
  for (const std::string& sweep : sweeps)
    for (SweepAxis& axis : parse_sweep(sweep)) axes.push_back(std::move(axis));
  request.points = sweep_points(axes, request.base, request.base, scene_traits(request.scene));
  request.machinery = rule;
  request.repeats = 1;
  request.shortest_sample = 0;
  StudyControl control;
  return run_chart(request, control);
}

const ChartPoint& point_of(const Chart& chart, const std::string& label) {
  const auto found = std::find_if(chart.points.begin(), chart.points.end(),
                                  [&](const ChartPoint& point) { return point.what.label == label; });
  if (found == chart.points.end()) throw InputError("no point " + label);
  return *found;
}

/// The mean of 16 x 16 samples for each pixel, from a picture that is so many times as wide and high.
Image<Rgb8> averaged(const Scene& scene, const View& view, const Settings& settings) {
  constexpr int side = 16;
  View large = view;
  large.width *= side;
  large.height *= side;
  const Frame frame = render(scene, large, settings);
  Image<Vec3d> means(view.width, view.height);
  for (int y = 0; y < large.height; ++y)
    for (int x = 0; x < large.width; ++x)
      means.at(x / side, y / side) += Vec3d(frame.colour.at(x, y)) / static_cast<double>(side * side);
  return display_image(means, display_transform(settings));
}

// One sample of a ray tracer is no truth: on textures it is as far from the mean over a pixel as a rasterizer's, or
// farther.
TEST(Chart, RenderersAreHeldAgainstTheMeanOverThePixel) {
  test::SeededRandom random;
  ChartRequest request;
  request.scene = load_scene("cgfs/crates");
  const int width = test::side(90 + static_cast<int>(random() % 40));
  request.view = {request.scene.camera, width, width};
  request.base = settings_for(request.scene);
  request.base.shadows = Shadows::none;
  const SceneTraits traits = scene_traits(request.scene);
  request.points = sweep_points(parse_sweep("renderers"), request.base, request.base, traits);
  request.repeats = 1;
  request.shortest_sample = 0;
  StudyControl control;
  const Chart chart = run_chart(request, control);
  Settings rays = request.base;
  rays.renderer = Renderer::ray_tracer;
  const Image<Rgb8> truth = averaged(request.scene, request.view, rays);
  ASSERT_TRUE(chart.reference_halves);
  const double uncertain = chart.reference_halves->rmse / 2;
  std::vector<double> errors, measured;
  for (const ChartPoint& point : chart.points) {
    errors.push_back(point.error);
    measured.push_back(compare_images(truth, *point.picture).rmse);
    EXPECT_NEAR(errors.back(), measured.back(), uncertain) << point.what.label << ", " << width << " px";
    EXPECT_GT(point.error, 4) << "one sample for each pixel, on textures";
    EXPECT_EQ(point.standing, Standing::compared);
  }
  for (const ChartClaim& claim : chart_conclusion(chart).claims)
    if (claim.kind == ChartClaim::Kind::more_exact) {
      EXPECT_LT(measured[static_cast<std::size_t>(claim.first)], measured[static_cast<std::size_t>(claim.second)]);
    }
}

TEST(Chart, PointsThatLeaveSomethingOutSaySo) {
  const Chart chart = swept_chart("cgfs/shadows", {"renderer=ray-tracer,rasterizer"});
  EXPECT_TRUE(chart.points[0].left_out.empty());
  ASSERT_EQ(chart.points[1].left_out, (std::vector<LeftOutBrief>{{BriefVerb::leaves_out, "shadows"}}));
  EXPECT_EQ(mark_label(chart, chart.points[1], "rasterizer").find("rasterizer ("), 0u);
  for (const std::string& text : {chart_conclusion(chart).sentence, chart_csv(chart), chart_json(chart),
                                  chart_svg(chart), mark_label(chart, chart.points[1], "rasterizer")})
    EXPECT_NE(text.find("leaves out shadows"), std::string::npos) << text;
  const Chart shown = swept_chart("cgfs/shadows", {"renderer=ray-tracer,rasterizer"}, {"shadows=map"});
  EXPECT_EQ(chart_conclusion(shown).sentence.find("leaves out"), std::string::npos);
}

TEST(Chart, TheTruthItselfHasNoErrorOfItsOwn) {
  Chart chart = swept_chart("cgfs/reflections", {"reflection-depth=0,3,64"});
  const ChartPoint& truth = chart.points[2];
  EXPECT_EQ(truth.standing, Standing::truth);
  chart.points[2].comparison.rmse = 0.32;  // as rounding to float may have it
  summarise(chart, ErrorMetric::rmse);
  EXPECT_EQ(truth.error, 0);
  EXPECT_EQ(chart.points[1].standing, Standing::compared);
  const auto json = nlohmann::json::parse(chart_json(chart)).at("points");
  EXPECT_TRUE(json.at(2).at("error").is_null());
  EXPECT_EQ(json.at(2).at("standing"), "truth");
  EXPECT_TRUE(json.at(1).at("error").is_number());
  EXPECT_NE(chart_svg(chart).find("64 (the truth)"), std::string::npos);
  // Held against the mean over a pixel, every picture of one sample has an error.
  const Chart tessellated = swept_chart("cgfs/spheres", {"tessellation=0.05,2"}, {"renderer=rasterizer"});
  for (const ChartPoint& point : tessellated.points) EXPECT_EQ(point.standing, Standing::compared);
}

// What is not swept is the same in the reference: neither missing reflections nor anti-aliasing count as an error.
TEST(Chart, ErrorsAreThoseOfTheSweptOptionAlone) {
  const Chart guards = swept_chart("cgfs/reflections", {"self-hit"});
  EXPECT_LT(point_of(guards, "offset").error, 0.05);
  EXPECT_GT(point_of(guards, "epsilon").error, 10 * point_of(guards, "offset").error);
  for (const char* renderer : {"renderer=ray-tracer", "renderer=rasterizer"}) {
    const Chart accelerators = swept_chart("cgfs/shading", {"threads=1,2"}, {renderer, "simd=off"});
    for (const ChartPoint& point : accelerators.points) EXPECT_LT(point.error, 0.5) << renderer;
  }
  const Chart filters = swept_chart("cgfs/crates", {"texture-filter"}, {"renderer=rasterizer"});
  EXPECT_LT(point_of(filters, "trilinear").error, point_of(filters, "nearest").error);
  const Chart depths = swept_chart("cgfs/reflections", {"reflection-depth=0,1,2,4,8"});
  for (std::size_t i = 1; i < depths.points.size(); ++i) EXPECT_LT(depths.points[i].error, depths.points[i - 1].error);
  const Chart samples = swept_chart("cgfs/reflections", {"samples-per-pixel=1,4,16"});
  EXPECT_GT(samples.points[0].error, 2 * samples.points[1].error);
  EXPECT_GT(samples.points[1].error, 2 * samples.points[2].error);
}

// The scalar path visits another tree than the SIMD one, so counted nodes show which of them was timed.
TEST(Chart, AllPointsRunOnTheSameMachinery) {
  const Chart same = swept_chart("cgfs/shading", {"accelerator=bvh,box"});
  EXPECT_NE(same.identity.machinery.find("all on scalar code, because of 'box'"), std::string::npos)
      << same.identity.machinery;
  const Chart fast = swept_chart("cgfs/reflections", {"reflection-depth=0,3"});
  const bool simd = widest_simd(Simd::automatic).has_value();
  EXPECT_EQ(fast.identity.machinery, simd ? "all on SIMD code" : "all on scalar code");
  if (!simd) return;
  const Chart used = swept_chart("cgfs/shading", {"accelerator=bvh,box"}, {}, MachineryRule::as_used);
  EXPECT_NE(used.identity.machinery.find("as used"), std::string::npos) << used.identity.machinery;
  EXPECT_FALSE(same.identity == used.identity) << "their times do not mix";
  EXPECT_EQ(point_of(same, "bvh").work, point_of(used, "bvh").work) << "work is counted by the scalar path";
  const Chart against = swept_chart("cgfs/shading", {"simd=auto,off"});
  EXPECT_NE(against.identity.machinery.find("SIMD itself"), std::string::npos);
}

TEST(Chart, WorkTakesThePlaceOfTime) {
  Chart chart = swept_chart("cgfs/reflections", {"reflection-depth=0,1,3"});
  chart.across = ChartAcross::work;
  summarise(chart, ErrorMetric::rmse);
  for (const ChartPoint& point : chart.points) {
    EXPECT_EQ(point.cost.median, static_cast<double>(point.work.value()));
    EXPECT_TRUE(point.on_front) << "more bounces, more work, less error";
  }
  EXPECT_NE(chart_svg(chart).find("work: rays"), std::string::npos);
  EXPECT_EQ(chart_svg(chart).find("time of one picture"), std::string::npos);
  EXPECT_EQ(parse_enumerator<ChartAcross>("across", "work"), ChartAcross::work);
  EXPECT_EQ(parse_enumerator<ChartAcross>("across", "memory"), ChartAcross::memory);
  EXPECT_THROW(parse_enumerator<ChartAcross>("across", "bytes"), InputError);
}

TEST(Chart, LabelsLieOverTheirRimsInAnyViewer) {
  ChartRequest request = small_request();
  StudyControl control;
  const Chart chart = run_chart(request, control);
  const std::string svg = chart_svg(chart);
  EXPECT_EQ(svg.find("paint-order"), std::string::npos) << "ImageMagick and others draw the stroke last";
  const auto times = [&](const std::string& text) {
    std::size_t found = 0;
    for (std::size_t at = svg.find(text); at != std::string::npos; at = svg.find(text, at + 1)) ++found;
    return found;
  };
  std::size_t shown = 0;
  const SweepNames names = chart_names(chart);
  for (std::size_t i = 0; i < chart.points.size(); ++i) {
    const ChartPoint& point = chart.points[i];
    const std::string words = ">" + mark_label(chart, point, names.parts[i]) + "</text>";
    const std::size_t first = svg.find(words);
    if (first == std::string::npos) continue;
    ++shown;
    EXPECT_EQ(times(words), 2u) << point.what.label;
    const std::string rim = svg.substr(svg.rfind('<', first), first - svg.rfind('<', first));
    const std::size_t second = svg.find(words, first + 1);
    const std::string letters = svg.substr(svg.rfind('<', second), second - svg.rfind('<', second));
    EXPECT_NE(rim.find("stroke=\"#ffffff\""), std::string::npos) << rim;
    EXPECT_EQ(letters.find("stroke"), std::string::npos) << letters;
  }
  EXPECT_GT(shown, 0u);
}

}  // namespace
}  // namespace ps::chart_test
