#include <gtest/gtest.h>

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/machine.h"
#include "base/version.h"
#include "document/permalink.h"
#include "image/file.h"
#include "options/option.h"
#include "support/run_cli.h"
#include "support/trials.h"

namespace ps::cli_test {
namespace {

using nlohmann::json;
using test::run_cli;
using test::run_cli_well;
using test::ScratchFolder;

/// The story of a pixel and the picture must show the same levels.
void expect_inspect_equals_render(const std::string& scene, const std::vector<std::string>& settings) {
  const ScratchFolder folder;
  const std::string out = folder.file("picture.png");
  constexpr int width = test::side(120), height = test::side(90);
  std::vector<std::string> common{scene, "--size", std::to_string(width) + "x" + std::to_string(height)};
  for (const std::string& setting : settings) common.insert(common.end(), {"--set", setting});
  std::vector<std::string> render{"render", "--out", out};
  render.insert(render.end(), common.begin(), common.end());
  run_cli_well(render);
  const Image<Rgb8> picture = load_levels(out);
  ASSERT_EQ(picture.width(), width);
  ASSERT_EQ(picture.height(), height);
  constexpr std::array pixels{Vec2i{0, 0}, Vec2i{width - 1, height - 1}, Vec2i{width / 2, height / 2},
                              Vec2i{test::side(41), test::side(60)}, Vec2i{test::side(80), test::side(50)}};
  for (std::size_t i = 0; i < pixels.size(); i += test::list_step) {
    const Vec2i pixel = pixels[i];
    std::vector<std::string> inspect{"inspect", "--json", "--pixel",
                                     std::to_string(pixel.x) + "," + std::to_string(pixel.y)};
    inspect.insert(inspect.end(), common.begin(), common.end());
    const auto inspected = run_cli_well(inspect);
    const json story = json::parse(inspected.out);
    const Rgb8 level = picture.at(pixel.x, pixel.y);
    EXPECT_EQ(story["colour"]["display"], json({level.r, level.g, level.b})) << inspected.out;
    EXPECT_EQ(story["pixel"], json({pixel.x, pixel.y}));
    EXPECT_FALSE(story["verdict"].get<std::string>().empty());
    EXPECT_FALSE(story["events"].empty());
    std::array<double, 3> sum{};
    for (const json& line : story["ledger"])
      if (line["level"] == 0)
        for (std::size_t c = 0; c < 3; ++c) sum[c] += line["value"][c].get<double>();
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], story["colour"]["linear"][c].get<double>(), 2e-6);
  }
}

TEST(Cli, InspectShowsWhatRenderStoresForRays) {
  expect_inspect_equals_render("cgfs/reflections", {});
  expect_inspect_equals_render("cgfs/mirrors", {"exposure=1.5", "colour-depth=15"});
  expect_inspect_equals_render("cgfs/shadows", {"precision=double", "self-hit=epsilon", "sample-position=corner"});
}

TEST(Cli, InspectShowsWhatRenderStoresForFragments) {
  expect_inspect_equals_render("cgfs/shading", {"renderer=rasterizer", "gamma=2.2"});
  expect_inspect_equals_render("cgfs/crates", {"renderer=rasterizer", "texture-filter=bilinear"});
  expect_inspect_equals_render("cgfs/depth", {"renderer=rasterizer", "visibility=painter"});
  expect_inspect_equals_render("cgfs/reflections", {"renderer=rasterizer", "precision=double"});
}

TEST(Cli, OptionsListsTheWholeTable) {
  const auto result = run_cli_well({"options", "--json"});
  const json options = json::parse(result.out);
  ASSERT_EQ(options.size(), option_table().size());
  for (std::size_t i = 0; i < options.size(); ++i) {
    EXPECT_EQ(options[i]["key"], option_table()[i].key);
    EXPECT_EQ(options[i]["default"], option_text(option_table()[i], Settings{}));
  }
  const auto text = run_cli({"options"});
  for (const Option& option : option_table())
    EXPECT_NE(text.out.find(fmt::format("  {} ", option.key)), std::string::npos) << option.key;
}

TEST(Cli, ARegionAloneAndEveryView) {
  const ScratchFolder folder;
  const auto picture = [&](std::vector<std::string> more) {
    const std::string out = folder.file("picture.png");
    std::vector<std::string> arguments{"render", "cgfs/reflections", "--size", "60x40", "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    run_cli_well(arguments);
    return load_levels(out);
  };
  const Image<Rgb8> all = picture({}), part = picture({"--region", "20,10,15,12"});
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 60; ++x) {
      const bool inside = x >= 20 && x < 35 && y >= 10 && y < 22;
      ASSERT_EQ(part.at(x, y), inside ? all.at(x, y) : (Rgb8{0, 0, 0})) << x << " " << y;
    }
  for (const char* show : {"direction", "hit", "samples", "nan"})
    EXPECT_EQ(picture({"--show", show, "--set", "samples-per-pixel=4", "--set", "adaptive-sampling=on"}).width(), 60);
  EXPECT_EQ(picture({"--show", "hit"}).at(30, 30), (Rgb8{255, 255, 255}));
}

TEST(Cli, InspectShowsWhatRenderStoresForSeveralRays) {
  expect_inspect_equals_render("cgfs/reflections", {"samples-per-pixel=9", "sample-pattern=jitter"});
  expect_inspect_equals_render("cgfs/fence", {"samples-per-pixel=64", "adaptive-sampling=on"});
  expect_inspect_equals_render("cgfs/fence", {"subsampling=8"});
  expect_inspect_equals_render("cgfs/brick-wall", {});
  expect_inspect_equals_render("cgfs/brick-wall", {"renderer=rasterizer"});
}

TEST(Cli, PicturesHoldTheirPermalink) {
  const ScratchFolder folder;
  const std::string out = folder.file("picture.png");
  ASSERT_EQ(
      run_cli({"render", "cgfs/reflections", "--size", "20x10", "--set", "reflection-depth=1", "--out", out}).status,
      0);
  for (const ImageText& text : load_texts(out))
    if (text.key == "permalink") {
      const Document document = parse_permalink(text.value);
      EXPECT_EQ(document.scene_name, "cgfs/reflections");
      EXPECT_EQ(document.view.width, 20);
      EXPECT_EQ(document.a.settings.reflection_depth, 1);
      return;
    }
  FAIL() << "no permalink in the picture";
}

TEST(Cli, StatsShowTheWork) {
  const ScratchFolder folder;
  const std::string stats = folder.file("stats.json");
  ASSERT_EQ(run_cli({"render", "cgfs/spheres", "--size", "20x10", "--set", "threads=1", "--out", folder.file("a.ppm"),
                     "--stats", stats})
                .status,
            0);
  std::ifstream file(stats);
  const json read = json::parse(file);
  EXPECT_EQ(read["counters"]["eye-rays"], 200);
  EXPECT_EQ(read["threads"], 1);
  EXPECT_EQ(read["settings"]["renderer"], "ray-tracer");
  EXPECT_EQ(read["program"], fmt::format("pixelscope {}", version()));
  EXPECT_GE(read["time_ms"].get<double>(), 0);
}

TEST(Cli, StatsNameTheSimdTarget) {
  const ScratchFolder folder;
  const auto simd = [&](const std::string& scene, const std::vector<std::string>& settings) {
    const std::string stats = folder.file("stats.json");
    std::vector<std::string> arguments{"render",  scene, "--size", "20x10", "--out", folder.file("a.ppm"),
                                       "--stats", stats};
    for (const std::string& setting : settings) {
      arguments.push_back("--set");
      arguments.push_back(setting);
    }
    EXPECT_EQ(run_cli(arguments).status, 0);
    std::ifstream file(stats);
    return json::parse(file)["simd"].get<std::string>();
  };
  const std::string best = this_machine().simd;
  for (const std::string scene : {"cgfs/spheres", "cgfs/shading"})
    for (const std::string renderer : {"renderer=ray-tracer", "renderer=rasterizer"}) {
      EXPECT_EQ(simd(scene, {renderer}), best) << scene << " " << renderer;
      EXPECT_EQ(simd(scene, {renderer, "simd=off"}), "none") << scene << " " << renderer;
      EXPECT_EQ(simd(scene, {renderer, "precision=double"}), "none") << scene << " " << renderer;
      EXPECT_EQ(simd(scene, {renderer, "simd=sse4"}), best == "none" ? "none" : "SSE4") << scene << " " << renderer;
    }
  EXPECT_EQ(simd("cgfs/spheres", {"renderer=textbook"}), "none");
}

TEST(Cli, CompareCountsDifferences) {
  const ScratchFolder folder;
  const std::string a = folder.write("a.ppm", "P3 2 1 255 0 0 0 10 20 30\n");
  const std::string b = folder.write("b.ppm", "P3 2 1 255 0 0 0 10 26 30\n");
  const json same = json::parse(run_cli({"compare", a, a, "--json"}).out);
  EXPECT_EQ(same["identical"], true);
  EXPECT_TRUE(same["psnr"].is_null());
  const auto result = run_cli_well({"compare", a, b, "--json", "--diff", folder.file("d.png")});
  const json different = json::parse(result.out);
  EXPECT_EQ(different["identical"], false);
  EXPECT_EQ(different["differing"], 1);
  EXPECT_EQ(different["max"], 6);
  EXPECT_EQ(different["mae"], 1);  // one channel of six differs, by 6
  EXPECT_EQ(load_levels(folder.file("d.png")).at(1, 0), (Rgb8{0, 6, 0}));
}

TEST(Cli, StabilityPrintsItsTable) {
  // Distance = epsilon times the length of the vector to the light; (1, 4, 4) has a length of the root of 33.
  const auto printed = run_cli_well({"stability", "epsilon-unit"});
  EXPECT_NE(printed.out.find("0.005745"), std::string::npos) << printed.out;
  const ScratchFolder folder;
  const auto kept = run_cli_well({"stability", "epsilon-unit", "--out", folder.file("tables")});
  EXPECT_EQ(kept.out, printed.out);
  EXPECT_TRUE(std::filesystem::exists(folder.file("tables/epsilon-unit.csv")));
}

TEST(Cli, StabilityPrintsADashWhereThereIsNoSuchMethod) {
  const auto printed = run_cli_well({"stability", "nan-in-a-picture"});
  EXPECT_NE(printed.out.find("            -            1  not finite"), std::string::npos) << printed.out;
}

TEST(Cli, NeedsPrintsItsAdviceAndHowItWasFound) {
  const auto printed = run_cli_well({"needs", "cgfs/cubes", "--size", "40x30", "--repeats", "1"});
  for (const char* sentence :
       {"refraction (no material of the scene is transparent)", "advice     renderer=rasterizer\n", "  taken\n"})
    EXPECT_NE(printed.out.find(sentence), std::string::npos) << sentence << "\n" << printed.out;
}

TEST(Cli, HelpAndVersionSucceed) {
  const auto version_result = run_cli_well({"--version"});
  EXPECT_NE(version_result.out.find(version()), std::string::npos);
  EXPECT_EQ(run_cli({"--help"}).status, 0);
  EXPECT_EQ(run_cli({"render", "--help"}).status, 0);
}

TEST(Cli, ScenesAreListed) {
  const auto result = run_cli_well({"scenes"});
  for (const char* name : {"cgfs/spheres", "cgfs/shadows", "cgfs/reflections", "cgfs/crates"})
    EXPECT_NE(result.out.find(name), std::string::npos) << name;
}

}  // namespace
}  // namespace ps::cli_test
