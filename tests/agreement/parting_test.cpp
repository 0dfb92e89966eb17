#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "base/enumerators.h"
#include "document/document.h"
#include "frame/display_frame.h"
#include "image/display.h"
#include "inspect/parting/align_stories.h"
#include "inspect/parting/parting.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/render_once.h"
#include "support/settings_with.h"

namespace ps::parting_test {
namespace {

/// Two ways of making one picture whose difference has one known cause.
struct PreparedPair {
  const char* name;
  const char* scene;
  std::vector<std::string> both, a, b;  ///< options
  PartingCause cause;
};

void PrintTo(const PreparedPair& pair, std::ostream* out) { *out << pair.name; }

/// A square whose left and upper edges run exactly through sample positions: x = 10.5 and y = 10.5 of 64 pixels.
constexpr const char* edges_through_samples = R"(canvas_size = 64 x 64
viewport_size = 1 x 1
projection_plane_d = 1
settings {
    renderer = rasterizer
    lighting = off
    backface-culling = off
}
model {
    name = square
    vertices {
        0 = (-0.3359375,  0.3359375, 0)
        1 = ( 0.2500000,  0.3359375, 0)
        2 = ( 0.2500000, -0.2500000, 0)
        3 = (-0.3359375, -0.2500000, 0)
    }
    triangles {
        0 = 0, 1, 2, red
        1 = 0, 2, 3, red
    }
}
instance { model = square  position = (0, 0, 1) }
)";

/// A built-in scene by its name, or the scene in a text of several lines.
Scene scene_of(const std::string& text) {
  return text.find('\n') == std::string::npos ? load_scene(text) : parse_scene(text, "test", ".");
}

const std::vector<PreparedPair>& prepared_pairs() {
  static const std::vector<PreparedPair> all{
      {"Epsilon",
       "cgfs/reflections",
       {"reflection-depth=0", "self-hit=epsilon"},
       {"shadow-epsilon=0"},
       {},
       PartingCause::epsilon},
      {"VolumeCaps",
       "lab/inside-shadow",
       {"renderer=rasterizer", "shadows=stencil-depth-fail"},
       {"volume-caps=off"},
       {},
       PartingCause::missing_shadow},
      {"StencilBits",
       "lab/stacked-shadows",
       {"renderer=rasterizer", "shadows=stencil-depth-fail"},
       {"stencil-bits=4"},
       {"stencil-bits=8"},
       PartingCause::missing_shadow},
      {"ShadowBias",
       "lab/shadow-acne",
       {"renderer=rasterizer", "shadows=map", "shadow-bias=0"},
       {"shadow-slope-bias=0"},
       {"shadow-slope-bias=0.6"},
       PartingCause::missing_shadow},
      {"ReflectionEpsilon",
       "cgfs/reflections",
       {"self-hit=epsilon"},
       {"reflection-epsilon=0"},
       {},
       PartingCause::epsilon},
      {"MissingBounce", "cgfs/reflections", {}, {"reflection-depth=1"}, {}, PartingCause::missing_bounce},
      {"OtherRoot", "cgfs/lights", {"shadows=none"}, {}, {"near=3"}, PartingCause::other_root},
      {"MissingShadow", "cgfs/shadows", {}, {}, {"shadows=none"}, PartingCause::missing_shadow},
      {"Precision",
       "cgfs/reflections",
       {"reflection-depth=0", "shadows=none", "sphere-test=quadratic"},
       {"precision=double"},
       {},
       PartingCause::precision},
      {"Culling",
       "cgfs/depth",
       {"renderer=rasterizer"},
       {"backface-culling=on"},
       {"backface-culling=off"},
       PartingCause::culling},
      {"Clipping", "cgfs/cubes", {"renderer=rasterizer"}, {}, {"near=6.5"}, PartingCause::clipping},
      {"FillRule", edges_through_samples, {}, {}, {"fill-rule=exclusive"}, PartingCause::fill_rule},
      {"DepthOrder", "cgfs/depth", {"renderer=rasterizer"}, {}, {"visibility=draw-order"}, PartingCause::visibility},
      {"Level", "cgfs/crates", {"renderer=rasterizer"}, {}, {"mip-bias=2"}, PartingCause::level},
      {"Filter",
       "cgfs/crates",
       {"renderer=rasterizer"},
       {"texture-filter=nearest"},
       {"texture-filter=bilinear"},
       PartingCause::filter},
      {"Interpolation",
       "cgfs/crates",
       {"renderer=rasterizer"},
       {},
       {"interpolation=affine"},
       PartingCause::interpolation},
      {"Tessellation", "cgfs/spheres", {"renderer=rasterizer"}, {}, {"tessellation=8"}, PartingCause::tessellation},
      {"RoundAgainstFlat",
       "cgfs/spheres",
       {},
       {},
       {"renderer=rasterizer", "tessellation=4"},
       PartingCause::tessellation},
      {"Silhouette",
       "cgfs/cubes",
       {"lighting=off", "backface-culling=off"},
       {},
       {"renderer=rasterizer"},
       PartingCause::silhouette},
      {"ShadingPosition",
       "cgfs/shading",
       {"shadows=none", "reflection-depth=0"},
       {},
       {"renderer=rasterizer", "shading=gouraud"},
       PartingCause::shading_position},
      {"Highlight", "cgfs/lights", {"shadows=none"}, {}, {"highlight=blinn-phong"}, PartingCause::light_model},
      {"Texture", "cgfs/crates", {"renderer=rasterizer"}, {}, {"textures=off"}, PartingCause::texture},
      {"EyeRay", "cgfs/spheres", {}, {}, {"sample-position=corner"}, PartingCause::eye_ray},
      {"ListingEyeRay", "cgfs/spheres", {}, {"renderer=textbook"}, {}, PartingCause::eye_ray},
      {"ListingLight",
       "cgfs/lights",
       {},
       {"renderer=textbook", "listing=cgfs-02-basic-ray-tracing"},
       {},
       PartingCause::light_model},
      {"ListingShadow",
       "cgfs/shadows",
       {"sample-position=corner"},
       {"renderer=textbook", "listing=cgfs-03-light"},
       {},
       PartingCause::missing_shadow},
      {"ListingBounce",
       "cgfs/reflections",
       {},
       {"renderer=textbook", "reflection-depth=0"},
       {},
       PartingCause::missing_bounce},
      {"ListingEpsilon",
       "cgfs/reflections",
       {"sample-position=corner", "reflection-depth=0", "precision=double"},
       {"renderer=textbook", "shadow-epsilon=0"},
       {"self-hit=epsilon"},
       PartingCause::epsilon},
      {"ListingPrecision",
       "cgfs/reflections",
       {"sample-position=corner", "self-hit=epsilon", "sphere-test=quadratic", "reflection-depth=0"},
       {"renderer=textbook"},
       {},
       PartingCause::precision},
      {"ListingTexture",
       "cgfs/crates",
       {"renderer=rasterizer"},
       {"renderer=textbook", "listing=cgfs-13-shading"},
       {},
       PartingCause::texture},
      {"Display", "cgfs/lights", {}, {}, {"gamma=2.2"}, PartingCause::display},
  };
  return all;
}

Settings settings_of(const Scene& scene, const PreparedPair& pair, const std::vector<std::string>& own) {
  return settings_with(settings_with(settings_for(scene), pair.both), own);
}

/// Pixels at which the two stored pictures differ, at most `count`, spread over all of them.
std::vector<Vec2i> differing_pixels(const Image<Rgb8>& a, const Image<Rgb8>& b, std::size_t count) {
  std::vector<Vec2i> all;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (!(a.at(x, y) == b.at(x, y))) all.push_back({x, y});
  std::vector<Vec2i> chosen;
  const std::size_t step = std::max<std::size_t>(all.size() / count, 1);
  for (std::size_t i = step / 2; i < all.size() && chosen.size() < count; i += step) chosen.push_back(all[i]);
  return chosen;
}

class PreparedPairs : public testing::TestWithParam<PreparedPair> {};

// Looks at forty of the differing pixels of each pair: the cause that was built in must be named at nearly all of them
// (a second difference behind a mirror, or an edge next to it, may come first at a few), from either side.
TEST_P(PreparedPairs, PartForTheReasonThatWasBuiltIn) {
  const PreparedPair& pair = GetParam();
  const Scene scene = scene_of(pair.scene);
  const View view{scene.camera, scene.canvas_width, scene.canvas_height};
  const Settings a = settings_of(scene, pair, pair.a), b = settings_of(scene, pair, pair.b);
  Prepared prepared;
  Progress progress;
  const auto picture = [&](const Settings& settings) {
    return display_frame(render(scene, view, settings, {}, prepared, progress), settings);
  };
  const auto pixels = differing_pixels(picture(a), picture(b), 40);
  ASSERT_FALSE(pixels.empty()) << "the two pictures do not differ";
  std::size_t right = 0;
  std::map<std::string, int> others;
  for (const Vec2i& pixel : pixels) {
    const PixelStory story_a = inspect(scene, view, a, pixel, prepared, progress);
    const PixelStory story_b = inspect(scene, view, b, pixel, prepared, progress);
    const Parting parting = find_parting(scene, {story_a, a}, {story_b, b});
    const Parting swapped = find_parting(scene, {story_b, b}, {story_a, a});
    EXPECT_EQ(parting.cause, swapped.cause) << parting.sentence << "\n" << swapped.sentence;
    EXPECT_FALSE(parting.sentence.empty());
    EXPECT_LT(parting.event_a, static_cast<int>(story_a.events.size()));
    EXPECT_LT(parting.event_b, static_cast<int>(story_b.events.size()));
    if (parting.cause == pair.cause)
      ++right;
    else
      ++others[std::string(enumerator_key(parting.cause)) + " at " + std::to_string(pixel.x) + "," +
               std::to_string(pixel.y) + ": " + parting.sentence];
  }
  std::ostringstream said;
  for (const auto& [sentence, count] : others) said << sentence << "\n";
  EXPECT_GE(right * 10, pixels.size() * 9) << right << " of " << pixels.size() << "\n" << said.str();
}

INSTANTIATE_TEST_SUITE_P(All, PreparedPairs, testing::ValuesIn(prepared_pairs()),
                         [](const auto& tested) { return tested.param.name; });

// A listing that fills triangles by rows of whole pixels: beside the rasterizer either its rounding or its rule for
// edges is to blame, beside rays the outline or two triangles that meet there. Nothing stays unexplained.
TEST(Parting, NamesWhatAListingOfTrianglesDoes) {
  const Scene scene = load_scene("cgfs/cubes");
  const View view{scene.camera, scene.canvas_width, scene.canvas_height};
  Settings listed = settings_for(scene), rasterized = listed, traced = listed;
  listed.renderer = Renderer::textbook;
  rasterized.renderer = Renderer::rasterizer;
  rasterized.sample_position = SamplePosition::corner;
  traced.renderer = Renderer::ray_tracer;
  Prepared prepared;
  Progress progress;
  const auto causes_beside = [&](const Settings& other) {
    const auto picture = [&](const Settings& settings) {
      return display_frame(render(scene, view, settings, {}, prepared, progress), settings);
    };
    std::map<PartingCause, int> causes;
    for (const Vec2i& pixel : differing_pixels(picture(listed), picture(other), 40)) {
      const PixelStory a = inspect(scene, view, listed, pixel, prepared, progress);
      const PixelStory b = inspect(scene, view, other, pixel, prepared, progress);
      ++causes[find_parting(scene, {a, listed}, {b, other}).cause];
    }
    return causes;
  };
  auto beside_fragments = causes_beside(rasterized);
  EXPECT_GT(beside_fragments[PartingCause::coverage], 5);
  EXPECT_GT(beside_fragments[PartingCause::fill_rule], 5);
  EXPECT_EQ(beside_fragments.size(), 2u);
  auto beside_rays = causes_beside(traced);
  EXPECT_GT(beside_rays[PartingCause::silhouette], 20);
  EXPECT_EQ(beside_rays[PartingCause::unexplained], 0);
}

TEST(Parting, SaysNothingWherePicturesAgree) {
  const Scene scene = load_scene("cgfs/reflections");
  const View view{scene.camera, scene.canvas_width, scene.canvas_height};
  const Settings settings = settings_for(scene);
  const PixelStory story = inspect(scene, view, settings, {300, 420});
  EXPECT_EQ(find_parting(scene, {story, settings}, {story, settings}).cause, PartingCause::none);
}

// The first frame that anyone sees: A traced, B rasterized. The marked pixel faces away from one light, which a shadow
// ray finds blocked and the rasterizer does not ask about; what tells the pictures apart is the mirror.
TEST(Parting, NamesTheMirrorAtTheFirstPixel) {
  const Document document = open_document("cgfs/reflections", load_scene("cgfs/reflections"));
  const Settings& a = document.a.settings;
  const Settings& b = document.b.settings;
  ASSERT_EQ(a.renderer, Renderer::ray_tracer);
  ASSERT_EQ(b.renderer, Renderer::rasterizer);
  const View view = view_of(document);
  Prepared prepared;
  Progress progress;
  for (const Vec2i pixel : {document.pixel, Vec2i{300, 420}}) {
    const PixelStory story_a = inspect(document.scene, view, a, pixel, prepared, progress);
    const PixelStory story_b = inspect(document.scene, view, b, pixel, prepared, progress);
    const Parting parting = find_parting(document.scene, {story_a, a}, {story_b, b});
    EXPECT_EQ(parting.cause, PartingCause::missing_bounce) << parting.sentence;
    EXPECT_NE(parting.sentence.find("mirrored ray"), std::string::npos) << parting.sentence;
  }
}

// A ray's story beside a fragment's: what both report stands in one row, where both see the same thing it counts as
// the same, and no event is lost or listed twice.
TEST(AlignStories, PutsARayBesideAFragment) {
  const Scene scene = load_scene("cgfs/reflections");
  const View view{scene.camera, scene.canvas_width, scene.canvas_height};
  const Settings traced = settings_for(scene);
  Settings rasterized = traced;
  rasterized.renderer = Renderer::rasterizer;
  const PixelStory ray = inspect(scene, view, traced, {300, 420});
  const PixelStory fragment = inspect(scene, view, rasterized, {300, 420});
  for (const bool swapped : {false, true}) {
    const PixelStory &a = swapped ? fragment : ray, &b = swapped ? ray : fragment;
    const auto rows = align_stories(a, b, scene);
    std::multiset<int> listed_a, listed_b;
    int lights = 0, seen = 0;
    for (const AlignedRow& row : rows) {
      if (row.a >= 0) listed_a.insert(row.a);
      if (row.b >= 0) listed_b.insert(row.b);
      if (row.a < 0 || row.b < 0) continue;
      const EventData &of_a = a.events[static_cast<std::size_t>(row.a)].data,
                      &of_b = b.events[static_cast<std::size_t>(row.b)].data;
      lights += std::holds_alternative<LightEvent>(of_a) && std::holds_alternative<LightEvent>(of_b) ? 1 : 0;
      const bool hit = std::holds_alternative<HitEvent>(swapped ? of_b : of_a);
      const bool covers = std::holds_alternative<FragmentEvent>(swapped ? of_a : of_b);
      if (hit && covers) {
        ++seen;
        EXPECT_TRUE(row.same);
      }
    }
    EXPECT_EQ(lights, 3);
    EXPECT_EQ(seen, 1);
    for (std::size_t i = 0; i < a.events.size(); ++i) EXPECT_EQ(listed_a.count(static_cast<int>(i)), 1u) << i;
    for (std::size_t i = 0; i < b.events.size(); ++i) EXPECT_EQ(listed_b.count(static_cast<int>(i)), 1u) << i;
  }
}

// A colour that was changed behind the events' back must not be explained away.
TEST(Parting, CallsAnUnknownCauseUnexplained) {
  const Scene scene = load_scene("cgfs/reflections");
  const View view{scene.camera, scene.canvas_width, scene.canvas_height};
  const Settings settings = settings_for(scene);
  const PixelStory story = inspect(scene, view, settings, {300, 420});
  PixelStory forged = story;
  forged.linear.x += 0.25;
  EXPECT_EQ(find_parting(scene, {story, settings}, {forged, settings}).cause, PartingCause::unexplained);
}

}  // namespace
}  // namespace ps::parting_test
