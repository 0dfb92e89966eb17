// A permalink in place of the arguments that it holds: the same pictures, stories and studies.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "document/command_line.h"
#include "document/permalink.h"
#include "document/permalink_file.h"
#include "image/file.h"
#include "scene/load.h"
#include "support/run_cli.h"

namespace ps::linked_command_test {
namespace {

using test::run_cli;
using test::run_cli_well;
using test::ScratchFolder;

const std::string linked_camera = "0.5,0.2,-1,1,0,0,0,1,0,0,0,1,1,1,1";

/// All that the commands take and a permalink holds.
std::vector<std::string> with_everything(std::vector<std::string> command) {
  command.insert(command.end(),
                 {"cgfs/reflections", "--size", "60x40", "--set", "reflection-depth=1", "--set", "gamma=1.5", "--edit",
                  "light.2.intensity=0.3", "--edit", "material.1.color=(1, 2, 200)", "--camera", linked_camera});
  return command;
}

std::string linked_picture(const std::vector<std::string>& command, const ScratchFolder& folder,
                           const std::string& name) {
  std::vector<std::string> arguments = command;
  arguments.insert(arguments.end(), {"--out", folder.file(name)});
  run_cli_well(arguments);
  return read_whole_file(folder.file(name));
}

TEST(LinkedCommand, ThePictureIsThatOfTheOptionsByteForByte) {
  const ScratchFolder folder;
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{}, {"--region", "10,5,30,20"}, {"--show", "depth"}}) {
    auto command = with_everything({"render"});
    command.insert(command.end(), more.begin(), more.end());
    const std::string picture = linked_picture(command, folder, "options.png");
    const std::string link = permalink_in_file(folder.file("options.png")).value_or("");
    ASSERT_FALSE(link.empty());
    EXPECT_EQ(linked_picture({"render", "--permalink", link}, folder, "link.png"), picture);
    EXPECT_EQ(linked_picture({"render", "--permalink", folder.file("options.png")}, folder, "file.png"), picture);
    const std::string line = folder.write("screen.permalink", link + "\n");
    EXPECT_EQ(linked_picture({"render", "--permalink", line}, folder, "line.png"), picture);
  }
}

TEST(LinkedCommand, OtherOptionsCountMore) {
  const ScratchFolder folder;
  linked_picture(with_everything({"render"}), folder, "options.png");
  const std::string link = permalink_in_file(folder.file("options.png")).value();
  auto changed = with_everything({"render"});
  changed.insert(changed.end(), {"--set", "gamma=2.2", "--edit", "light.2.intensity=0.1", "--show", "normal"});
  *(std::find(changed.begin(), changed.end(), "60x40")) = "30x20";
  const std::string wanted = linked_picture(changed, folder, "changed.png");
  EXPECT_EQ(linked_picture({"render", "--permalink", link, "--size", "30x20", "--set", "gamma=2.2", "--edit",
                            "light.2.intensity=0.1", "--show", "normal"},
                           folder, "over.png"),
            wanted);
  linked_picture({"render", "cgfs/spheres", "--permalink", "scene=cgfs/lines&size=60x40"}, folder, "scene.png");
  const Image<Rgb8> levels = load_levels(folder.file("scene.png"));
  linked_picture({"render", "--permalink", "scene=cgfs/spheres&size=60x40"}, folder, "spheres.png");
  EXPECT_EQ(levels, load_levels(folder.file("spheres.png")));
}

TEST(LinkedCommand, TheSideThatIsPickedOrAskedFor) {
  const ScratchFolder folder;
  const std::string link = "scene=cgfs/reflections&size=60x40&b.renderer=rasterizer&show-b=depth";
  const auto levels = [&](const std::vector<std::string>& command) {
    linked_picture(command, folder, "side.png");
    return load_levels(folder.file("side.png"));
  };
  const auto a = levels({"render", "cgfs/reflections", "--size", "60x40"});
  const auto b =
      levels({"render", "cgfs/reflections", "--size", "60x40", "--set", "renderer=rasterizer", "--show", "depth"});
  ASSERT_NE(a, b);
  EXPECT_EQ(levels({"render", "--permalink", link}), a);
  EXPECT_EQ(levels({"render", "--permalink", link, "--side", "b"}), b);
  EXPECT_EQ(levels({"render", "--permalink", link + "&picked=b"}), b);
  EXPECT_EQ(levels({"render", "--permalink", link + "&picked=b", "--side", "a"}), a);
}

TEST(LinkedCommand, StoriesAndStudies) {
  const ScratchFolder folder;
  const std::string link = "scene=cgfs/reflections&size=60x40&pixel=20,30&a.reflection-depth=1&sweep=gamma%3d1,2";
  const std::vector<std::string> explicit_story{"inspect", "cgfs/reflections",  "--size", "60x40", "--pixel", "20,30",
                                                "--set",   "reflection-depth=1"};
  const auto story = run_cli_well(explicit_story);
  EXPECT_EQ(run_cli({"inspect", "--permalink", link}).out, story.out);
  const auto elsewhere = run_cli({"inspect", "--permalink", link, "--pixel", "1,2"});
  EXPECT_TRUE(elsewhere.out.starts_with("pixel (1, 2)")) << elsewhere.out;
  const auto features = [](const std::vector<std::string>& command) {
    std::vector<std::string> lines;
    const auto found = nlohmann::json::parse(run_cli(command).out);
    for (const auto& feature : found["features"])
      lines.push_back(fmt::format("{} {}", feature["name"].get<std::string>(), feature["error_without"].get<double>()));
    return lines;
  };
  const auto needs = features({"needs", "--permalink", link, "--repeats", "1", "--json"});
  EXPECT_FALSE(needs.empty());
  EXPECT_EQ(needs, features({"needs", "cgfs/reflections", "--size", "60x40", "--set", "reflection-depth=1", "--repeats",
                             "1", "--json"}));
  ASSERT_EQ(run_cli({"chart", "--permalink", link, "--repeats", "1", "--out", folder.file("chart")}).status, 0);
  const auto chart = nlohmann::json::parse(read_whole_file(folder.file("chart/points.json")));
  EXPECT_EQ(chart["size"], nlohmann::json({60, 40}));
  EXPECT_EQ(chart["base-settings"], "reflection-depth=1");
  ASSERT_EQ(chart["points"].size(), 2u) << "of the permalink's sweep";
  EXPECT_EQ(chart["points"][1]["label"], "gamma 2");
}

TEST(LinkedCommand, WhatTheWindowPrints) {
  Document document = open_document("cgfs/reflections", load_scene("cgfs/reflections"));
  document.pixel = {3, 4};
  const std::string link = permalink(document);
  EXPECT_EQ(linked_command(document, LinkedCommand::render),
            "pixelscope-cli render --permalink '" + link + "' --out picture.png");
  EXPECT_EQ(linked_command(document, LinkedCommand::inspect), "pixelscope-cli inspect --permalink '" + link + "'");
}

TEST(LinkedCommand, BadLinksAreRefused) {
  const ScratchFolder folder;
  const std::string out = folder.file("never.png");
  ASSERT_EQ(run_cli({"precision", "cgfs/lens", "--size", "9x9", "--out", folder.file("other.png")}).status, 0);
  save_image(folder.file("none.png"), Image<Rgb8>(2, 2));
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& message) {
    const auto result = run_cli(arguments);
    EXPECT_EQ(result.status, 2) << message;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  };
  refused({"render", "--out", out}, "SCENE is required");
  refused({"render", "--permalink", "nothing", "--out", out}, "found 'nothing', expected a permalink");
  refused({"render", "--permalink", folder.file("gone.permalink"), "--out", out}, "no such file");
  refused({"render", "--permalink", folder.file("none.png"), "--out", out}, "contains no permalink");
  refused({"render", "--permalink", "a.gamma=2", "--out", out}, "names no scene");
  refused({"render", "--permalink", "scene=cgfs/nothing", "--out", out}, "cgfs/nothing");
  refused({"render", "--permalink", "scene=cgfs/lens&a.gamma=nan", "--out", out}, "gamma");
  refused({"render", "--permalink", "scene=cgfs/lens", "--side", "c", "--out", out}, "expected a or b");
  refused({"render", "cgfs/lens", "--side", "b", "--out", out}, "needs --permalink");
  refused({"render", "--permalink", "scene=cgfs/lens&picture-b=x.png", "--side", "b", "--out", out}, "x.png");
  refused({"inspect", "cgfs/lens"}, "--pixel is required");
  refused({"inspect", "--permalink", "scene=cgfs/lens"}, "no picked pixel");
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace ps::linked_command_test
