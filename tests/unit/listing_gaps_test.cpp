// Every listing names what of a scene it leaves out: wherever something changes the pictures of a renderer and not
// those of the listing, it is reported, and what the listing draws is not.
#include <gtest/gtest.h>

#include <algorithm>

#include "obj_corpus.h"
#include "options/listing.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/left_out.h"
#include "scene/scene_file.h"
#include "support/render_once.h"

namespace ps::listing_gaps_test {
namespace {

/// The parts of a scene that a trait changes, and the words of what is left out without it.
struct Trait {
  const char* words;
  std::string material, light, textures;
  std::string before = {};  ///< of the material that it is compared with
};

const std::vector<Trait> traits_of_light{
    {"colours of lights", "", "color = linear (1, 0.4, 0.2)", ""},
    {"attenuation of lights", "", "attenuation = (0.5, 0.2, 0.1)", ""},
    {"colours of highlights and ambient light", "specular_color = linear (0, 1, 0)", "", ""},
    {"colours of highlights and ambient light", "ambient_color = linear (0, 0, 1)", "", ""},
    {"colours of highlights and ambient light", "specular_map = t", "", "file = t.ppm"},
    {"normal maps", "normal_map = t", "", "file = t.ppm"},
    {"reflection maps", "reflective = 0.5 reflection_map = t", "", "file = t.ppm", "reflective = 0.5"},
    {"textures", "texture = t", "", "file = t.ppm"},
    {"transparency", "transparency = 0.5", "", ""},
};

/// A ball or a wall, lit by an ambient and a point light.
Scene scene_with(const test::ModelFolder& folder, bool ball, const Trait& trait) {
  const std::string texture = trait.textures.empty() ? "" : "texture { name = t " + trait.textures + " }\n";
  const std::string colour =
      "material { name = m  color = linear (0.6, 0.5, 0.4)  specular = 4 " + trait.material + " }\n";
  const std::string shape =
      ball ? "sphere { center = (0.3, 0.2, 4) radius = 1.6 material = m }\n"
           : "model { name = wall  material = m  vertices = [(-2, -1.7, 3), (-2, 2, 3.5), (2, 1.9, 3), (2, -2, 4)]\n"
             "  uvs = [(0, 1), (0, 0), (1, 0), (1, 1)]\n"
             "  triangles { 0 = { vertices = [0, 1, 2] uvs = [0, 1, 2] } 1 = { vertices = [0, 2, 3] uvs = [0, 2, 3] } "
             "} }\ninstance { model = wall }\n";
  return parse_scene(texture + colour + shape +
                         "background = linear (0.1, 0.2, 0.3)\nlight { type = ambient intensity = 0.3 }\n" +
                         "light { type = point intensity = 0.7 position = (1, 1, 0) " + trait.light + " }\n",
                     "gaps.scene", folder.path().string());
}

Image<Vec3f> picture(const Scene& scene, const Settings& settings) {
  return render(scene, {scene.camera, 40, 40}, settings).colour;
}

/// Of one renderer, which rounds alike.
bool differ(const Image<Vec3f>& a, const Image<Vec3f>& b) {
  for (std::size_t i = 0; i < a.pixels().size(); ++i)
    for (int channel = 0; channel < 3; ++channel)
      if (std::abs(a.pixels()[i][channel] - b.pixels()[i][channel]) > 1e-5f) return true;
  return false;
}

bool reports(const Scene& scene, const Settings& settings, std::string_view words) {
  const auto all = left_out(scene_traits(scene), settings);
  return std::any_of(all.begin(), all.end(),
                     [&](const LeftOut& one) { return brief_text(one.brief).find(words) != std::string::npos; });
}

TEST(ListingGaps, AreReportedByEveryListingThatHasThem) {
  const test::ModelFolder folder;
  folder.write("t.ppm", "P3 2 2 255  255 128 200  100 200 255  90 140 230  128 128 255\n");
  int gaps = 0, drawn = 0;
  for (const bool ball : {true, false}) {
    for (const NamedListing& listing : listings()) {
      const ListingDraws& draws = listing.listing->draws;
      if (!(ball ? draws.spheres : draws.models)) continue;
      Settings listed{.renderer = Renderer::textbook};
      parse_assignment("listing=" + listing.key, listed);
      Settings traced = listed;
      traced.renderer = Renderer::ray_tracer;
      traced.sample_position = SamplePosition::corner;
      for (const Trait& trait : traits_of_light) {
        const Scene scene = scene_with(folder, ball, trait),
                    plain = scene_with(folder, ball, {"", trait.before, "", ""});
        const std::string words = listing.key + (ball ? ", ball: " : ", wall: ") + trait.words + " " + trait.material;
        // Under no light of its own a listing lacks all of what light shows; that light is missing is said instead.
        if (!draws.light) {
          EXPECT_TRUE(reports(scene, listed, "light")) << words;
          continue;
        }
        ASSERT_TRUE(differ(picture(plain, traced), picture(scene, traced))) << words << " makes no difference to rays";
        const bool shown = differ(picture(plain, listed), picture(scene, listed));
        EXPECT_EQ(reports(scene, listed, trait.words), !shown) << words;
        EXPECT_FALSE(reports(plain, listed, trait.words)) << words;
        (shown ? drawn : gaps) += 1;
        const PixelStory story = inspect(scene, {scene.camera, 40, 40}, listed, {20, 20});
        EXPECT_EQ(story.verdict.find(trait.words) != std::string::npos, !shown) << words << ": " << story.verdict;
      }
    }
  }
  EXPECT_GT(gaps, 20);
  EXPECT_GT(drawn, 3);
}

}  // namespace
}  // namespace ps::listing_gaps_test
