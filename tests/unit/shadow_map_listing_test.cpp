// The listing of CGFS ch. 15: what it leaves out, and its shadow map in the story of a pixel.
#include <gtest/gtest.h>

#include "options/option.h"
#include "options/scene_settings.h"
#include "render/left_out.h"
#include "render/story/story_tree.h"
#include "scene/load.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::shadow_map_listing_test {
namespace {

constexpr const char* yard = "chapters/cgfs_15_shadows_in_the_rasterizer/yard.scene";

Settings textbook(const Scene& scene) {
  Settings settings = settings_for(scene, Renderer::textbook);
  return settings;
}

/// The routine of chapter 15 has maps for parallel light alone, and this is said.
TEST(ShadowMapListing, SaysThatPointLightsCastNoShadows) {
  const auto left_out_by = [](const char* name) {
    const Scene scene = load_scene(name);
    Settings settings = textbook(scene);
    parse_assignment("listing=cgfs-15-shadows-in-the-rasterizer", settings);
    std::string all;
    for (const LeftOut& one : left_out(scene_traits(scene), settings)) all += brief_text(one.brief) + ";";
    return all;
  };
  EXPECT_EQ(left_out_by("cgfs/shading"), "leaves out shadows of point lights;");
  EXPECT_EQ(left_out_by(yard), "");
}

/// Where the sun is hidden the story has the texel that says so, with the depths that were compared.
TEST(ShadowMapListing, LookupsAreInItsStory) {
  const Scene scene = load_scene(yard);
  const View view{scene.camera, scene.canvas_width, scene.canvas_height};
  int lit = 0, dark = 0;
  for (int x = 4; x < 600; x += 9) {
    const PixelStory story = inspect(scene, view, textbook(scene), {x, 230});
    for (const auto* map : events_of<ShadowMapEvent>(story.events)) {
      ASSERT_EQ(map->taps.size(), 1u) << x;
      const bool sees = !(map->taps[0].stored < map->depth - map->bias);
      EXPECT_EQ(map->taps[0].lit, sees) << x;
      ++(sees ? lit : dark);
    }
    for (const auto* light : events_of<LightEvent>(story.events)) {
      if (light->kind != LightKind::directional) continue;
      EXPECT_EQ(light->visible == 0, light->diffuse == 0 && !light->below_horizon) << x;
    }
  }
  EXPECT_GT(lit, 20);
  EXPECT_GT(dark, 3);
}

}  // namespace
}  // namespace ps::shadow_map_listing_test
