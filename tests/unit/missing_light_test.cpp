// A black picture says why: no light in the scene, none that shines, or only one shown that adds nothing. And shadows
// that rays trace where shadow volumes are asked for are called traced.
#include <gtest/gtest.h>

#include <algorithm>

#include "options/option.h"
#include "options/scene_settings.h"
#include "render/left_out.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/render_once.h"
#include "support/run_cli.h"
#include "support/settings_with.h"

namespace ps::missing_light_test {
namespace {

Scene lit_by(const std::string& lights) {
  return parse_scene("sphere { center = (0, 0.8, 4) radius = 1.5 color = red }\n"
                     "triangle { vertices = [(-2, -2, 5), (-2, 2, 5), (2, 2, 5)] color = white }\n" +
                         lights,
                     "dark.scene", ".");
}

/// The verdict of a pixel, and the words below the picture.
std::string said(const Scene& scene, const Settings& settings) {
  std::string all = inspect(scene, {scene.camera, 40, 40}, settings, {20, 20}).verdict;
  for (const LeftOut& one : left_out(scene_traits(scene), settings)) all += "\n" + one.notice;
  return all;
}

bool is_black(const Scene& scene, const Settings& settings) {
  return render(scene, {scene.camera, 40, 40}, settings).colour.at(20, 20) == Vec3f(0);
}

TEST(MissingLight, IsNamedWhereverThePictureIsBlack) {
  const std::string point = "light { type = point intensity = 0.6 position = (0, 0, 0) }\n";
  const std::string dark = "light { type = ambient intensity = 0 }\n",
                    ambient = "light { type = ambient intensity = 0.2 }\n";
  const std::string black = "light { type = directional intensity = 1 direction = (0, 0, -1) color = black }\n";
  for (const char* renderer : {"renderer=ray-tracer", "renderer=rasterizer", "renderer=textbook"})
    for (const std::string& lights :
         {std::string(), dark, dark + black, ambient, point, dark + point, ambient + dark + point})
      for (const char* shown : {"light-shown=all", "light-shown=0", "light-shown=1", "light-shown=5"}) {
        const Scene scene = lit_by(lights);
        const Settings settings = settings_with({}, {renderer, shown});
        const std::string words = said(scene, settings);
        EXPECT_EQ(words.find("shows black surfaces") != std::string::npos, is_black(scene, settings))
            << renderer << " " << shown << " " << lights << ": " << words;
        EXPECT_EQ(words.find("No light") != std::string::npos, is_black(scene, settings)) << words;
        for (const LeftOut& one : left_out(scene_traits(scene), settings))
          if (brief_text(one.brief).find("black surfaces") != std::string::npos)
            for (const Remedy& remedy : one.remedies) {
              Settings mended = settings;
              parse_assignment(remedy.setting, mended);
              EXPECT_TRUE(!is_black(scene, mended) || remedy.setting == "light-shown=all") << remedy.setting;
            }
      }
}

TEST(MissingLight, IsNotMissedWhereNothingAsksForIt) {
  const Scene scene = lit_by("");
  for (const char* off : {"lighting=off", "draw=wireframe"}) {
    const std::string words = said(scene, settings_with({}, {"renderer=rasterizer", off}));
    EXPECT_EQ(words.find("light"), std::string::npos) << off << ": " << words;
  }
  EXPECT_EQ(said(load_scene("cgfs/lines"), settings_with({}, {"renderer=rasterizer"})).find("No light"),
            std::string::npos);
}

TEST(MissingLight, TheCommandLineSaysIt) {
  const test::ScratchFolder folder;
  const std::string scene = folder.write("dark.scene", "sphere { center = (0, 0, 4) radius = 1 color = red }\n");
  const auto drawn = test::run_cli({"render", scene, "--size", "8x8", "--out", folder.file("a.png")});
  EXPECT_NE(drawn.err.find("black surfaces, since the scene has no light"), std::string::npos) << drawn.err;
}

// Rays have no shadow volumes: the same picture as with traced shadows, and it is said.
TEST(TracedShadows, AreCalledSoWhateverIsAskedFor) {
  const Scene scene = load_scene("cgfs/shadows");
  const SceneTraits traits = scene_traits(scene);
  const Option& option = *find_option("shadows");
  const auto traced = render(scene, {scene.camera, 60, 60}, settings_with({}, {"shadows=traced"})).colour;
  for (const Choice& choice : option.choices) {
    const Settings settings = settings_with({}, {"shadows=" + std::string(choice.key)});
    const bool named_another = choice.key.starts_with("stencil");
    const auto picture = render(scene, {scene.camera, 60, 60}, settings).colour;
    const bool same = std::ranges::equal(picture.pixels(), traced.pixels());
    EXPECT_EQ(same, named_another || choice.key == "traced") << choice.key;
    EXPECT_EQ(said(scene, settings).find("Shadows are traced") != std::string::npos, named_another) << choice.key;
    EXPECT_EQ(inactive_value_reason(option, settings, traits).has_value(), named_another) << choice.key;
    Settings triangles = settings;
    triangles.renderer = Renderer::rasterizer;
    EXPECT_FALSE(inactive_value_reason(option, triangles, traits)) << choice.key;
  }
}

}  // namespace
}  // namespace ps::missing_light_test
