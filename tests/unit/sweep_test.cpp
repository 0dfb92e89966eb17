#include "study/sweep.h"

#include <set>

#include <gtest/gtest.h>

#include "base/check.h"
#include "options/scene_settings.h"
#include "scene/load.h"

namespace ps::sweep_test {
namespace {

std::vector<SweepPoint> points_of(const std::vector<std::string>& texts, const std::string& scene_name) {
  const Scene scene = load_scene(scene_name);
  std::vector<SweepAxis> axes;
  for (const std::string& text : texts)
    for (SweepAxis& axis : parse_sweep(text)) axes.push_back(axis);
  const Settings start = settings_for(scene);
  return sweep_points(axes, start, start, scene_traits(scene));
}

TEST(Sweep, GivesEveryCombinationOnce) {
  const auto points = points_of({"reflection-depth=0,2,5", "precision"}, "cgfs/reflections");
  ASSERT_EQ(points.size(), 6u);
  std::set<std::pair<int, Precision>> seen;
  for (const SweepPoint& point : points) seen.insert({point.value.reflection_depth, point.value.precision});
  EXPECT_EQ(seen.size(), 6u);
  EXPECT_EQ(points[0].settings, "reflection-depth=0;precision=float");
  EXPECT_EQ(points[1].label, "reflection-depth 0, double");
}

TEST(Sweep, AnOptionThatCannotActDoesNotMultiplyPoints) {
  // The rasterizer has no reflected rays: three depths for rays, one point for it.
  const auto points = points_of({"renderer=ray-tracer,rasterizer", "reflection-depth=0,1,3"}, "cgfs/reflections");
  int rasterized = 0;
  for (const SweepPoint& point : points) rasterized += point.value.renderer == Renderer::rasterizer ? 1 : 0;
  EXPECT_EQ(points.size(), 4u);
  EXPECT_EQ(rasterized, 1);
}

TEST(Sweep, PointsReproduceTheirSettingsFromTheirText) {
  for (const NamedSweep& sweep : named_sweeps())
    for (const char* name : {"cgfs/reflections", "cgfs/crates"}) {
      const Settings start = settings_for(load_scene(name));
      std::set<std::string> labels;
      for (const SweepPoint& point : points_of({std::string(sweep.key)}, name)) {
        Settings read = start;
        parse_assignments(point.settings, read);
        EXPECT_EQ(read, point.value) << sweep.key << ": " << point.settings;
        EXPECT_TRUE(labels.insert(point.label).second) << sweep.key << ": two points are called " << point.label;
      }
    }
}

TEST(Sweep, LabelsSayWhatActsAndNoMore) {
  std::set<std::string> labels;
  for (const SweepPoint& point : points_of({"shadow-methods"}, "cgfs/shadows")) labels.insert(point.label);
  EXPECT_TRUE(labels.contains("none"));
  EXPECT_TRUE(labels.contains("map, map-size 256, filter 2"));
}

TEST(Sweep, NamesAreWordsWithWhatIsCommonOnce) {
  std::vector<std::string> names;
  for (const SweepPoint& point : points_of({"samples"}, "cgfs/shadows")) names.push_back(point.name);
  ASSERT_EQ(names.size(), 4u);
  EXPECT_EQ(names[2], "Samples per pixel: 16");
  const SweepNames split = split_names(names);
  EXPECT_EQ(split.common, "Samples per pixel");
  EXPECT_EQ(split.parts, (std::vector<std::string>{"1", "4", "16", "64"}));
  std::set<std::string> methods;
  for (const SweepPoint& point : points_of({"shadow-methods"}, "cgfs/shadows")) {
    EXPECT_TRUE(methods.insert(point.name).second) << point.name;
    EXPECT_EQ(point.name.find('='), std::string::npos) << point.name;
  }
  EXPECT_TRUE(methods.contains("shadow map, size 256, filter 2"));
  EXPECT_EQ(split_names({methods.begin(), methods.end()}).common, "");
}

TEST(Sweep, ASweepOfOptionsThatCannotActSaysWhy) {
  const auto reason = [](const char* scene_name, std::string_view key) {
    const Scene scene = load_scene(scene_name);
    for (const NamedSweep& sweep : named_sweeps())
      if (sweep.key == key) return idle_sweep(sweep, settings_for(scene), scene_traits(scene));
    return std::optional<std::string>("no such sweep");
  };
  const auto filters = reason("cgfs/spheres", "texture-filters");
  ASSERT_TRUE(filters);
  EXPECT_NE(filters->find("texture"), std::string::npos) << *filters;
  EXPECT_FALSE(reason("cgfs/crates", "texture-filters"));
  for (const char* scene : {"cgfs/spheres", "cgfs/crates"})
    for (const char* key : {"renderers", "samples", "precision-and-tests"}) EXPECT_FALSE(reason(scene, key)) << key;
}

TEST(Sweep, StandardValuesOfEveryOptionAreValidAndDifferent) {
  for (const Option& option : option_table()) {
    const auto values = standard_values(option);
    EXPECT_GE(values.size(), 2u) << option.key;
    Settings settings;
    std::set<std::string> seen;
    for (const std::string& value : values) {
      EXPECT_NO_THROW(parse_option(option, value, settings)) << option.key << "=" << value;
      EXPECT_TRUE(seen.insert(option_text(option, settings)).second) << option.key << "=" << value;
      if (option.kind != OptionKind::choice) {
        EXPECT_LE(value.size(), 8u) << option.key << "=" << value;
      }
    }
  }
}

TEST(Sweep, NamedSweepsAreNotMistakenForOptions) {
  for (const NamedSweep& sweep : named_sweeps()) EXPECT_EQ(find_option(sweep.key), nullptr) << sweep.key;
}

TEST(Sweep, BadTextIsRefusedWithAMessage) {
  for (const char* text : {"no-such-option", "reflection-depth=0,x", "reflection-depth=", "reflection-depth=1,1",
                           "reflection-depth=999", "shading=phong,,flat", ""})
    EXPECT_THROW(parse_sweep(text), InputError) << text;
  EXPECT_THROW(points_of({"precision", "precision"}, "cgfs/spheres"), InputError);
}

TEST(Sweep, IsWrittenAsTextThatIsReadBack) {
  for (const NamedSweep& sweep : named_sweeps()) EXPECT_EQ(sweep_text(parse_sweep_text(sweep.key)), sweep.key);
  for (const char* text : {"reflection-depth=0,2", "shading=phong,flat;textures=on,off", "none"})
    EXPECT_EQ(sweep_text(parse_sweep_text(text)), text);
  EXPECT_EQ(sweep_text(parse_sweep_text("reflection-depth=0,1,2,3,4,6,8")), "reflection-depths") << "by its name";
  for (const char* text : {"", ";", "shading=phong;", "shading=phong;no-such-option", "renderers;shading"})
    EXPECT_THROW(parse_sweep_text(text), InputError) << text;
}

TEST(Sweep, ReportsOptionsThatActNowhere) {
  const Scene scene = load_scene("cgfs/spheres");
  const std::vector<SweepAxis> axes{parse_sweep_axis("texture-filter"), parse_sweep_axis("precision")};
  const auto sentences = idle_axes(axes, settings_for(scene), scene_traits(scene));
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_NE(sentences[0].find("texture"), std::string::npos);
}

}  // namespace
}  // namespace ps::sweep_test
