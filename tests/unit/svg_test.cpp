// Drawings as SVG: base 64 against RFC 4648, escaping, and that what is written can be parsed again.
#include "image/svg.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "inspect/microscope/micro_svg.h"
#include "inspect/space_drawing.h"
#include "inspect/space_orbit.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::svg_test {
namespace {

// The test vectors of RFC 4648, section 10.
TEST(Svg, Base64OfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(Svg, TextIsEscaped) { EXPECT_EQ(xml_escaped("a<b> & \"c\"'"), "a&lt;b&gt; &amp; &quot;c&quot;&apos;"); }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// Tags close in the order in which they open.
void expect_nested(const std::string& svg) {
  std::vector<std::string> open;
  for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
    const std::size_t end = svg.find('>', at);
    ASSERT_NE(end, std::string::npos);
    const std::string tag = svg.substr(at + 1, end - at - 1);
    ASSERT_EQ(tag.find('<'), std::string::npos) << tag;
    EXPECT_EQ(std::count(tag.begin(), tag.end(), '"') % 2, 0) << tag;
    const std::string name = tag.substr(tag[0] == '/' ? 1 : 0, tag.find_first_of(" /", 1) - (tag[0] == '/' ? 1 : 0));
    if (tag[0] == '/') {
      ASSERT_FALSE(open.empty()) << tag;
      EXPECT_EQ(open.back(), tag.substr(1));
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
  }
  EXPECT_TRUE(open.empty());
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

struct Inspected {
  Scene scene;
  View view;
  Settings settings;
  Prepared prepared;
  Progress progress;
  PixelStory story;
  Inspected(const std::string& name, Renderer renderer, Vec2i pixel) : scene(load_scene(name)) {
    view = {scene.camera, 200, 200};
    settings.renderer = renderer;
    story = inspect(scene, view, settings, pixel, prepared, progress);
  }
};

TEST(Svg, SpaceViewDrawsTheStory) {
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    Inspected inspected("cgfs/reflections", renderer, {100, 110});
    const SpaceModel model = build_space(inspected.scene, inspected.view, inspected.settings, &inspected.story);
    const SpaceOrbit orbit = preset_orbit(SpacePreset::outside, model.bounds, inspected.scene.camera, 1.5);
    const SpacePicture picture =
        draw_space_picture(inspected.scene, orbit_view(orbit, inspected.scene.camera, 900, 600), 0.02 * orbit.distance,
                           inspected.prepared, inspected.progress);
    const std::string svg = space_svg(model, picture);
    expect_nested(svg);
    EXPECT_EQ(count(svg, "<image "), 1u);
    EXPECT_GT(count(svg, "<line "), 5u);
    EXPECT_GT(count(svg, "light 1 (point)"), 0u);
    SpaceLook few;
    few.least_contribution = 0.9;
    if (renderer == Renderer::ray_tracer) {
      EXPECT_LT(count(space_svg(model, picture, few), "<line "), count(svg, "<line "));
    }
  }
}

// A box of a model's tree is one way along all of its twelve edges, whichever way the model is turned.
TEST(Svg, BoxesOfAModelAreDrawnWhole) {
  Inspected inspected("cgfs/crates", Renderer::ray_tracer, {113, 43});
  inspected.settings.accelerator = Accelerator::two_level;
  inspected.story =
      inspect(inspected.scene, inspected.view, inspected.settings, {113, 43}, inspected.prepared, inspected.progress);
  SpaceModel model = build_space(inspected.scene, inspected.view, inspected.settings, &inspected.story);
  std::erase_if(model.items,
                [](const SpaceItem& item) { return item.kind != SpaceKind::node || item.shape != SpaceShape::line; });
  ASSERT_FALSE(model.items.empty());
  const SpaceOrbit orbit = preset_orbit(SpacePreset::outside, model.bounds, inspected.scene.camera, 1.5);
  const SpacePicture picture = draw_space_picture(inspected.scene, orbit_view(orbit, inspected.scene.camera, 900, 600),
                                                  0.02 * orbit.distance, inspected.prepared, inspected.progress);
  SpaceLook look;
  look.groups[static_cast<std::size_t>(SpaceGroup::nodes)] = true;
  look.deepest_level = model.deepest_level;
  EXPECT_GE(count(space_svg(model, picture, look), "<line "), 12 * model.items.size());
}

TEST(Svg, MicroscopeDrawsThePixel) {
  for (const Renderer renderer : {Renderer::ray_tracer, Renderer::rasterizer}) {
    Inspected inspected("cgfs/crates", renderer, {113, 43});
    const Microscope scope(inspected.scene, inspected.view, inspected.settings, {113, 43}, inspected.prepared,
                           inspected.progress);
    const MicroReading reading = scope.read({0.5, 0.5}, inspected.prepared, inspected.progress);
    const std::string svg = micro_svg(scope, reading);
    expect_nested(svg);
    EXPECT_EQ(count(svg, "<image "), 1 + (reading.texture ? reading.texture->levels.size() : 0));
    EXPECT_EQ(count(svg, "weight in space"), renderer == Renderer::rasterizer ? 1u : 0u);
    EXPECT_EQ(count(svg, "<circle "), 1u);  // the sample
  }
}

}  // namespace
}  // namespace ps::svg_test
