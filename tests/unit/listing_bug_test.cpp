// Variants of the listings with one wrong line: that it is one, that it is seen, and that it acts where it should.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "frame/display_frame.h"
#include "inspect/parting/parting.h"
#include "math/has_nan.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "support/refusal.h"
#include "support/render_once.h"
#include "support/run_cli.h"
#include "support/settings_with.h"
#include "support/trials.h"
#include "textbook/bug_patch.h"
#include "textbook/listing_source.h"
#include "textbook/listing_view.h"

namespace ps::listing_bug_test {
namespace {

NamedListing variant_of(const ListingBug& bug) {
  return {std::string(bug.folder), {}, bug.listing, std::string(bug.name)};
}

/// The room for a listing beside a picture on a small screen: no line of it is broken there.
TEST(ListingBug, LinesOfListingsHaveAtMost68Columns) {
  for (const NamedListing& listing : listings()) {
    int number = 0;
    for (const std::string& line : listing_lines(listing_source(listing))) {
      ++number;
      EXPECT_LE(line.size(), 68u) << listing.folder << ", line " << number << ": " << line;
    }
    EXPECT_GT(number, 50) << listing.folder;
  }
  for (const ListingBug& bug : listing_bugs()) EXPECT_LE(bug_line(bug).wrong.size(), 68u) << bug.name;
}

TEST(ListingBug, EachIsOneLineThatIsShown) {
  EXPECT_GE(listing_bugs().size(), 20u);
  for (const ListingBug& bug : listing_bugs()) {
    const BugLine line = bug_line(bug);
    const ListingText right = load_listing_text({std::string(bug.folder), {}, bug.listing});
    const ListingText wrong = load_listing_text(variant_of(bug));
    ASSERT_EQ(right.lines.size(), wrong.lines.size()) << bug.name;
    int differing = 0;
    for (std::size_t i = 0; i < right.lines.size(); ++i) {
      EXPECT_EQ(right.lines[i].number, wrong.lines[i].number) << bug.name;
      if (right.lines[i].text == wrong.lines[i].text) continue;
      ++differing;
      EXPECT_EQ(wrong.lines[i].number, line.number) << bug.name;
      EXPECT_EQ(wrong.lines[i].text, line.wrong);
      EXPECT_EQ(right.lines[i].text, line.right);
    }
    EXPECT_EQ(differing, 1) << bug.name << ": the wrong line is behind a watch";
  }
}

TEST(ListingBug, EveryListingHasOneAndNamesDiffer) {
  std::set<std::string> folders, keys;
  for (const ListingBug& bug : listing_bugs()) {
    folders.insert(std::string(bug.folder));
    EXPECT_TRUE(keys.insert(bug.key).second) << bug.key;
    EXPECT_EQ(bug.symptom.back(), '.') << bug.key;
  }
  EXPECT_EQ(folders.size(), listings().size());
}

std::string objection(const std::string& listing, const std::string& text) {
  return test::refusal_of([&] { patch_listing(listing, parse_bug(text, "bugs/some.bug"), "bugs/some.bug"); });
}

TEST(ListingBug, OneLineOfTheListingIsReplaced) {
  const std::string listing = "#include <x>\nint f() {\n  return 1;\n}\n";
  const BugPatch bug = parse_bug("It is seen.\n- return 1;\n+ return 2;\n", "bugs/some.bug");
  const PatchedListing patched = patch_listing(listing, bug, "bugs/some.bug");
  EXPECT_EQ(bug.symptom, "It is seen.");
  EXPECT_EQ(patched.text, "#include <x>\nint f() {\n  return 2;\n}\n");
  EXPECT_EQ(patched.line.number, 3);
  EXPECT_EQ(patched.line.wrong, "  return 2;");
  EXPECT_EQ(patched.line.right, "  return 1;");
}

TEST(ListingBug, WhatIsNoPatchIsRefusedWithFileAndLine) {
  const std::string listing = "int f() {\n  return 1;\n}\nint g() {\n  return 1;\n}\n";
  EXPECT_EQ(objection(listing, "Seen.\n- int f() {\n+ int f(int) {\n"), "");
  EXPECT_EQ(objection(listing, "Seen.\n- return 3;\n+ return 2;\n"),
            "bugs/some.bug:2:1: found a line that listing.cpp has not, expected one that it has once");
  EXPECT_EQ(objection(listing, "Seen.\n- return 1;\n+ return 2;\n"),
            "bugs/some.bug:2:1: found a line that listing.cpp has twice, as 2 and 5, expected one that it has once");
  const std::pair<const char*, const char*> others[] = {
      {"", "bugs/some.bug: found 0 lines"},
      {"Seen.\n- int f() {\n", "bugs/some.bug: found 2 lines"},
      {"Seen\n- int f() {\n+ x\n", "bugs/some.bug:1:1: found 'Seen'"},
      {"Seen.\n-int f() {\n+ x\n", "bugs/some.bug:2:1: found '-int"},
      {"Seen.\n- int f() {\n- x\n", "bugs/some.bug:3:1: found '- x'"},
      {"Seen.\n- int f() {\n+ int f() {\n", "bugs/some.bug:3:1: found the"}};
  for (const auto& [text, start] : others)
    EXPECT_EQ(objection(listing, text).find(start), 0u) << objection(listing, text);
}

Image<Rgb8> picture(const Scene& scene, const Settings& settings) {
  return display_frame(render(scene, {scene.camera, 120, 120}, settings), settings);
}

/// The scene of each chapter that suits its listing.
const char* scene_for(std::string_view folder) {
  const std::pair<std::string_view, const char*> scenes[] = {
      {"cgfs_01_pixels_and_colours", "chapters/cgfs_01_pixels_and_colours/overlap.scene"},
      {"cgfs_02_basic_ray_tracing", "cgfs/spheres"},
      {"cgfs_03_light", "cgfs/lights"},
      {"cgfs_04_shadows_and_reflections", "chapters/cgfs_04_shadows_and_reflections/balloon.scene"},
      {"cgfs_05_camera", "chapters/cgfs_05_camera/turned.scene"},
      {"cgfs_05_solids", "cgfs/cubes"},
      {"cgfs_06_lines", "chapters/cgfs_06_lines/ends.scene"},
      {"cgfs_07_filled_triangles", "chapters/cgfs_07_filled_triangles/square.scene"},
      {"cgfs_08_shaded_triangles", "cgfs/shaded-triangle"},
      {"cgfs_09_perspective", "chapters/cgfs_09_perspective/cube.scene"},
      {"cgfs_10_scenes", "cgfs/cubes"},
      {"cgfs_11_clipping", "chapters/cgfs_11_clipping/two.scene"},
      {"cgfs_12_hidden_surfaces", "cgfs/depth"},
      {"cgfs_13_shading", "cgfs/shading"},
      {"cgfs_14_mipmaps", "chapters/cgfs_14_textures/closeup.scene"},
      {"cgfs_14_textures", "cgfs/crates"},
      {"cgfs_15_relief", "chapters/cgfs_15_relief/mirrored.scene"},
      {"cgfs_15_shadows_in_the_rasterizer", "chapters/cgfs_15_shadows_in_the_rasterizer/yard.scene"},
      {"cgpp_15_4_measured_light", "cgpp/ground"},
      {"cgpp_15_6_exact_edges", "chapters/cgpp_15_6_exact_edges/fan.scene"},
      {"cgpp_15_6_which_pixels", "cgfs/cubes"},
      {"lab_cornell", "lab/polygon-rows"},
      {"oct_dont_test_everything", "cgfs/cubes"}};
  for (const auto& [known, scene] : scenes)
    if (known == folder) return scene;
  return "";
}

Settings settings_of(const Scene& scene, const ListingBug& bug) {
  Settings settings = settings_for(scene, Renderer::textbook);
  for (std::size_t i = 0; i < listings().size(); ++i)
    if (listings()[i].folder == bug.folder) settings.listing = static_cast<int>(i) + 1;
  return settings;
}

void set_bug(Settings& settings, std::string_view key) {
  parse_assignment("listing-bug=" + std::string(key), settings);
}

/// No two of them give the same picture, nor that of the listing; without it the listing's picture is back.
TEST(ListingBug, EachChangesThePicture) {
  for (const ListingBug& bug : listing_bugs()) {
    const Scene scene = load_scene(scene_for(bug.folder));
    Settings settings = settings_of(scene, bug);
    settings.backface_culling = bug.name == "open_boxes";  // a bug of culling
    const Image<Rgb8> right = picture(scene, settings);
    set_bug(settings, bug.key);
    EXPECT_FALSE(inactive_value_reason(*find_option("listing-bug"), settings, scene_traits(scene))) << bug.key;
    const Image<Rgb8> wrong = picture(scene, settings);
    EXPECT_NE(wrong, right) << bug.key;
    for (const ListingBug& other : listing_bugs()) {
      if (other.folder != bug.folder || other.name == bug.name) continue;
      set_bug(settings, other.key);
      EXPECT_NE(picture(scene, settings), wrong) << bug.key << " and " << other.key;
    }
    set_bug(settings, "none");
    EXPECT_EQ(picture(scene, settings), right) << bug.key;
  }
}

/// The values of a pixel are those of its picture, also where a triangle is drawn far from its place.
TEST(ListingBug, TraceGivesTheColourOfThePicture) {
  for (const ListingBug& bug : listing_bugs()) {
    const Scene scene = load_scene(scene_for(bug.folder));
    const View view{scene.camera, 120, 120};
    Settings settings = settings_of(scene, bug);
    set_bug(settings, bug.key);
    const Frame frame = render(scene, view, settings);
    int differing = 0;
    constexpr int step = 7 * static_cast<int>(test::list_step);
    for (int y = 2; y < 120; y += step)
      for (int x = 1; x < 120; x += step) {
        const Vec3d traced = trace_listing(scene, view, settings, {x, y}).linear, drawn = frame.colour_double.at(x, y);
        if (traced != drawn && !(has_nan(traced) && has_nan(drawn))) ++differing;
      }
    EXPECT_EQ(differing, 0) << bug.key;
  }
}

TEST(ListingBug, ActsOnlyInItsListing) {
  const Scene scene = load_scene("cgfs/lights");
  const SceneTraits traits = scene_traits(scene);
  const Option& option = *find_option("listing-bug");
  Settings settings = settings_for(scene);
  EXPECT_EQ(text_of(inactive_reason(option, settings, traits)), "only textbook listings use it");
  settings.renderer = Renderer::textbook;
  EXPECT_FALSE(inactive_reason(option, settings, traits));
  const Image<Rgb8> right = picture(scene, settings);
  set_bug(settings, "no-horizon");  // of chapter 2
  EXPECT_EQ(text_of(inactive_value_reason(option, settings, traits)), "a bug of another listing");
  EXPECT_EQ(picture(scene, settings), right);
  EXPECT_EQ(running_listing(settings, traits).bug, "");
  set_bug(settings, "dazzling");
  EXPECT_FALSE(inactive_value_reason(option, settings, traits));
  EXPECT_EQ(running_listing(settings, traits).bug, "dazzling");
  settings.renderer = Renderer::ray_tracer;
  EXPECT_EQ(picture(scene, settings), picture(scene, settings_for(scene)));
}

/// Wherever a bug is seen, the parting says that there is a wrong line and where to look, and names neither it nor an
/// option: the options are equal, and what an event shows followed from the line.
TEST(ListingBug, ThePartingLeavesTheLineToTheStudent) {
  for (const ListingBug& bug : listing_bugs()) {
    const Scene scene = load_scene(scene_for(bug.folder));
    const View view{scene.camera, 120, 120};
    Settings b = settings_of(scene, bug), rasterized = settings_for(scene);
    b.backface_culling = bug.name == "open_boxes";
    Settings a = b;
    set_bug(a, bug.key);
    rasterized.renderer = Renderer::rasterizer;
    const Frame right = render(scene, view, b), wrong = render(scene, view, a);
    int looked_at = 0;
    for (int y = 0; y < 120 && looked_at < 5; ++y)
      for (int x = 0; x < 120 && looked_at < 5; ++x) {
        if (right.colour_double.at(x, y) == wrong.colour_double.at(x, y)) continue;
        ++looked_at;
        const PixelStory of_a = inspect(scene, view, a, {x, y});
        const PixelStory of_b = inspect(scene, view, b, {x, y});
        const Parting parting = find_parting(scene, {of_a, a}, {of_b, b}),
                      back = find_parting(scene, {of_b, b}, {of_a, a});
        EXPECT_EQ(parting.cause, PartingCause::planted_bug) << bug.key << ": " << parting.sentence;
        EXPECT_EQ(parting.sentence.find("The listings of A and B differ in one line: find it. A ends with"), 0u)
            << bug.key << ": " << parting.sentence;
        EXPECT_EQ(back.cause, PartingCause::planted_bug) << bug.key;
        const PixelStory other = inspect(scene, view, rasterized, {x, y});
        if (other.linear == of_a.linear) continue;
        EXPECT_EQ(
            find_parting(scene, {of_a, a}, {other, rasterized}).sentence.find("The listing of A has one wrong line"),
            0u)
            << bug.key;
      }
    EXPECT_GT(looked_at, 0) << bug.key;
  }
}

/// The values are beside the lines of the variant's own file, whose numbers are those of the listing.
TEST(ListingBug, InspectShowsItsLinesAndValues) {
  const auto shown = test::run_cli_well({"inspect", "cgfs/spheres", "--pixel", "300,430", "--set", "renderer=textbook",
                                         "--set", "listing-bug=sunken-spheres"});
  EXPECT_NE(shown.out.find("bugs/sunken_spheres.bug"), std::string::npos) << shown.out;
  const auto at = shown.out.find("  41    const double t2 = (-b - discriminant) / (2 * a);");
  ASSERT_NE(at, std::string::npos) << shown.out;
  EXPECT_NE(shown.out.substr(at, shown.out.find('\n', at) - at).find("| t1, t2 = ("), std::string::npos) << shown.out;
}

}  // namespace
}  // namespace ps::listing_bug_test
