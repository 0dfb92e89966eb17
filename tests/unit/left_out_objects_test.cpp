// Scenes of which the rasterizer leaves out an object: the others are drawn and reported as without it.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "options/option.h"
#include "options/scene_settings.h"
#include "render/left_out.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/render_once.h"
#include "support/run_cli.h"
#include "support/settings_with.h"
#include "support/trials.h"

namespace ps::left_out_objects_test {
namespace {

PixelStory story_of(const Scene& scene, const Settings& settings, Vec2i pixel, int size) {
  return inspect(scene, {scene.camera, size, size}, settings, pixel);
}

/// A triangle and a ball, after a lens by CSG or without it.
Scene with_lens(bool lens) {
  return parse_scene(
      std::string("viewport_size = 1 x 1\nprojection_plane_d = 1\nbackground = black\n") +
          (lens ? "intersection { name = lens  sphere { center = (-0.9, 0, 4)  radius = 1.4  color = red }\n"
                  "  sphere { center = (0.9, 0, 4)  radius = 1.4  color = blue } }\n"
                : "") +
          "triangle { name = t  vertices = [(-2, -2, 5), (-2, 2, 5), (2, 2, 5)]  color = white }\n"
          "sphere { name = s  center = (1, -0.5, 4)  radius = 0.5  color = red }\n"
          "light { type = ambient  intensity = 0.2 }\n"
          "light { type = point  intensity = 0.5  position = (3, 2, 0) }\n",
      "lens.scene", ".");
}

// CSG is left out, so the numbers of drawn things are not those of the scene's objects.
TEST(LeftOutObjects, ChangeNothingForTheOthersAndAreReported) {
  const Scene without = with_lens(false), with = with_lens(true);
  for (const char* assignment : {"draw=wireframe", "shading=gouraud", "shading=flat", "shadows=stencil-depth-fail",
                                 "shadows=map", "shading=phong"}) {
    Settings settings{.renderer = Renderer::rasterizer};
    parse_assignment(assignment, settings);
    const auto draw = [&](const Scene& scene, Shading shading) {
      Settings own = settings;
      own.shading = shading;
      return render(scene, {scene.camera, 60, 60}, own);
    };
    for (const Shading shading : {settings.shading, Shading::gouraud}) {
      const Frame a = draw(without, shading), b = draw(with, shading);
      EXPECT_TRUE(std::equal(a.colour.pixels().begin(), a.colour.pixels().end(), b.colour.pixels().begin()))
          << assignment;
    }
    const int step = 6 * static_cast<int>(test::list_step);
    for (int y = 1; y < 60; y += step)
      for (int x = 1; x < 60; x += step) {
        const PixelStory story = story_of(with, settings, {x, y}, 60);
        EXPECT_EQ(story.linear, story_of(without, settings, {x, y}, 60).linear) << assignment << " " << x << ", " << y;
        EXPECT_NE(story.verdict.find("leaves out CSG"), std::string::npos);
      }
  }
}

bool says_objects(const std::vector<LeftOut>& all) {
  return std::any_of(all.begin(), all.end(), [](const LeftOut& one) { return one.kind == LeftOutKind::objects; });
}

// An empty picture of a scene that is not empty is never left without a word.
TEST(LeftOutObjects, EveryEmptyPictureOfABuiltInSceneIsExplained) {
  int empty = 0;
  for (const BuiltinScene& built_in : builtin_scenes()) {
    const Scene scene = load_scene(built_in.name);
    const SceneTraits traits = scene_traits(scene);
    for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer, Renderer::textbook}) {
      // The listings cull by the winding of the book's own camera, which a camera of the other handedness turns round.
      const Camera& camera = scene.camera;
      if (renderer == Renderer::textbook && dot(cross(camera.right, camera.up), camera.forward) < 0) continue;
      Settings settings = settings_for(scene, renderer);
      // What lies on the canvas is measured in its pixels.
      const View view = traits.canvas_items ? View{scene.camera, scene.canvas_width, scene.canvas_height}
                                            : View{scene.camera, 40, 30};
      const Frame frame = render(scene, view, settings);
      const auto pixels = frame.colour.pixels();
      const bool blank =
          std::all_of(pixels.begin(), pixels.end(), [&](const Vec3f& c) { return c == Vec3f(scene.background); });
      SCOPED_TRACE(built_in.name + " " + std::to_string(static_cast<int>(renderer)));
      if (blank) {
        ++empty;
        EXPECT_TRUE(says_objects(left_out(traits, settings)));
      } else {
        EXPECT_FALSE(leaves_out_all(traits, settings));
      }
    }
  }
  EXPECT_GE(empty, 8) << "four scenes on the canvas by rays, CSG and solids by listings";
}

// One triangle is drawn; everything beside it is named.
TEST(LeftOutObjects, AListingNamesWhatStandsBesideItsTriangle) {
  const Scene scene = parse_scene("triangle { vertices = [(-2, -2, 5), (-2, 2, 5), (2, 2, 5)]  color = white }\n"
                                  "sphere { center = (0, 0, 4) radius = 0.5 color = red reflective = 0.5 }\n"
                                  "box { center = (1, 0, 4) size = (1, 1, 1) color = red }\n"
                                  "intersection { sphere { center = (0, 0, 9) radius = 1 } "
                                  "sphere { center = (0, 0, 9) radius = 2 } }\n"
                                  "light { type = point  intensity = 0.5  position = (3, 2, 0) }\n",
                                  "mixed.scene", ".");
  Settings settings{.renderer = Renderer::textbook};
  parse_assignment("listing=cgfs-13-shading", settings);
  const std::string verdict = story_of(scene, settings, {1, 1}, 8).verdict;
  for (const char* words : {"; the listing of CGFS ch. 13 leaves out ", "spheres",
                            "planes, rectangles, boxes and cylinders", "CSG", "shadows and reflections"})
    EXPECT_NE(verdict.find(words), std::string::npos) << words << ": " << verdict;
  EXPECT_EQ(verdict.find("models"), std::string::npos) << verdict;
  EXPECT_EQ(verdict.find("canvas"), std::string::npos) << verdict;
}

// One subject and one verb for all that is left out; what is shown in another way has its own verb.
TEST(LeftOutObjects, AVerdictNamesTheRendererOnce) {
  const Scene scene = parse_scene("sphere { center = (0, 0, 4)  radius = 1  color = red  transparency = 0.5 }\n"
                                  "sphere { center = (2, 0, 4)  radius = 1  color = red  reflective = 0.5 }\n"
                                  "light { type = point  intensity = 0.5  position = (3, 2, 0) }\n",
                                  "glass.scene", ".");
  EXPECT_EQ(left_out_words(scene_traits(scene), Settings{.renderer = Renderer::rasterizer}),
            "; the rasterizer leaves out shadows and reflections, and shows transparent surfaces as opaque");
}

// What is said about shadows and reflections is what the pictures show: they differ from those of rays, and the named
// remedy makes the words go.
TEST(LeftOutObjects, TheRasterizersMissingEffectsAreNamedUntilTheyAreThere) {
  const Scene scene = load_scene("cgfs/reflections");
  Settings settings{.renderer = Renderer::rasterizer};
  const auto words = [&] { return left_out_words(scene_traits(scene), settings); };
  EXPECT_EQ(words(), "; the rasterizer leaves out shadows and reflections");
  parse_assignment("shadows=map", settings);
  EXPECT_EQ(words(), "; the rasterizer leaves out reflections");
  parse_assignment("environment=cube-map", settings);
  EXPECT_EQ(words(), "");
  parse_assignment("shadows=none", settings);
  EXPECT_EQ(words(), "");
  EXPECT_EQ(left_out_words(scene_traits(scene), Settings{.renderer = Renderer::ray_tracer}), "");
}

// Each button does what it says: with its setting the thing is left out no longer, in every built-in scene.
TEST(LeftOutObjects, EveryRemedyEndsWhatItIsOfferedFor) {
  std::set<std::string> tried;
  for (const BuiltinScene& built_in : builtin_scenes()) {
    const Scene scene = load_scene(built_in.name);
    const SceneTraits traits = scene_traits(scene);
    for (const char* start : {"renderer=ray-tracer", "renderer=rasterizer", "renderer=textbook"})
      for (const char* more : {"shading=phong", "shading=gouraud", "environment=cube-map", "environment=room-map"}) {
        Settings settings = settings_for(scene);
        parse_assignment(start, settings);
        parse_assignment(more, settings);
        parse_assignment("environment-objects=static", settings);
        for (const LeftOut& one : left_out(traits, settings)) {
          ASSERT_FALSE(one.remedies.empty()) << brief_text(one.brief);
          EXPECT_FALSE(one.notice.empty()) << brief_text(one.brief);
          for (const Remedy& remedy : one.remedies) {
            Settings mended = settings;
            parse_assignment(remedy.setting, mended);
            for (const LeftOut& still : left_out(traits, mended))
              EXPECT_NE(brief_text(still.brief), brief_text(one.brief))
                  << built_in.name << ", " << start << ", " << remedy.setting;
            tried.insert(remedy.setting);
          }
        }
      }
  }
  for (const char* setting : {"shadows=map", "shadows=stencil-depth-fail", "environment=cube-map",
                              "renderer=ray-tracer", "renderer=rasterizer", "environment-objects=all"})
    EXPECT_TRUE(tried.contains(setting)) << setting << " is offered nowhere";
}

TEST(LeftOutObjects, TheCommandLineNamesThemWithTheRemedy) {
  const test::ScratchFolder folder;
  const std::string out = folder.file("a.png"), stats = folder.file("a.json");
  test::run_cli_well({"render", "cgfs/lines", "--size", "8x8", "--out", out, "--stats", stats});
  const auto rays = test::run_cli_well(
      {"render", "cgfs/lines", "--size", "8x8", "--out", out, "--set", "renderer=ray-tracer", "--stats", stats});
  EXPECT_NE(rays.err.find("Set renderer = rasterizer to see them."), std::string::npos) << rays.err;
  EXPECT_NE(read_text_file(stats, 1 << 20).find("The ray tracer leaves out lines"), std::string::npos);
}

}  // namespace
}  // namespace ps::left_out_objects_test
