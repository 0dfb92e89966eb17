// A renderer that a program brings along is one folder and one row: everything above the renderers takes it as it takes
// those of core, without an edit there.
#include <gtest/gtest.h>

#include "base/spelling.h"
#include "document/document.h"
#include "document/permalink.h"
#include "frame/display_frame.h"
#include "options/option.h"
#include "render/fast_path.h"
#include "render/left_out.h"
#include "render/renderer_table.h"
#include "scene/load.h"
#include "study/chart.h"
#include "study/counted_work.h"
#include "support/render_once.h"

namespace {

using namespace ps;

/// The last of the table. A function, since main() adds it later than variables begin.
Renderer constant() { return renderer_table().back().renderer; }

Settings constant_settings() {
  Settings settings;
  parse_assignment("renderer=constant", settings);
  return settings;
}

TEST(AddedRenderer, IsAChoiceOfTheOption) {
  const Option& option = *find_option("renderer");
  ASSERT_EQ(option.choices.size(), renderer_table().size());
  EXPECT_EQ(option.choices.back().key, "constant");
  EXPECT_EQ(option.maximum, static_cast<double>(option.choices.size() - 1));
  EXPECT_EQ(constant_settings().renderer, constant());
  EXPECT_EQ(option_text(option, constant_settings()), "constant");
  EXPECT_EQ(renderer_label(constant()), "constant colour");
  EXPECT_TRUE(draws_fragments(constant()));
  EXPECT_NE(renderer_for(PictureWay::fragments), constant()) << "the first of its way is core's";
}

TEST(AddedRenderer, MakesPicturesAndStories) {
  const Scene scene = load_scene("cgfs/reflections");
  const View view{scene.camera, 40, 30};
  const Frame frame = render(scene, view, constant_settings());
  EXPECT_EQ(frame.colour.at(3, 4), Vec3f(scene.background * 0.5));
  const PixelStory story = inspect(scene, view, constant_settings(), {3, 4});
  EXPECT_EQ(story.renderer, constant());
  const Rgb8 shown = display_frame(frame, constant_settings()).at(3, 4);
  EXPECT_EQ(story.display, (std::array<int, 3>{shown.r, shown.g, shown.b}));
  EXPECT_NE(story.verdict.find("; the constant renderer leaves out everything"), std::string::npos) << story.verdict;
  EXPECT_TRUE(leaves_out_all(scene_traits(scene), constant_settings()));
  EXPECT_EQ(fast_path(constant_settings(), scene_traits(scene), Channel::none).reason, "there is nothing to hurry");
}

TEST(AddedRenderer, GivesOnlyTheCountersOfItsRow) {
  const Scene scene = load_scene("cgfs/reflections");
  const Counters counters = render(scene, {scene.camera, 40, 30}, constant_settings()).counters;
  EXPECT_EQ(counters.get(Counter::pixels_written), 40u * 30u);
  for (std::size_t i = 0; i < counter_count; ++i) {
    const auto counter = static_cast<Counter>(i);
    if (counter == Counter::pixels_written) continue;
    EXPECT_EQ(counters.get(counter), std::nullopt) << counter_key(counter);
  }
  EXPECT_EQ(counted_work(counters), std::nullopt) << "no work at all would be a lie";
}

TEST(AddedRenderer, SaysWhichOptionsItUses) {
  const SceneTraits traits = scene_traits(load_scene("cgfs/crates"));
  const auto reason = [&](std::string_view key) {
    return text_of(inactive_reason(*find_option(key), constant_settings(), traits));
  };
  EXPECT_EQ(reason("exposure"), "");
  EXPECT_EQ(reason("renderer"), "");
  EXPECT_EQ(reason("backface-culling"), "one colour needs no such thing");
  EXPECT_EQ(reason("accelerator"), "only the ray tracer uses it");
}

TEST(AddedRenderer, IsPartOfPermalinks) {
  Document document = open_document("cgfs/reflections", load_scene("cgfs/reflections"));
  document.b.settings.renderer = constant();
  const std::string link = permalink(document);
  EXPECT_NE(link.find("b.renderer=constant"), std::string::npos) << link;
  EXPECT_EQ(parse_permalink(link).b.settings.renderer, constant());
}

TEST(AddedRenderer, HasNoPlaceAlongWorkThatItDoesNotCount) {
  Chart chart;
  for (const std::optional<std::uint64_t> work : {std::optional<std::uint64_t>(1000), {}}) {
    ChartPoint point;
    point.compared = true;
    point.samples_ms = {5};
    point.work = work;
    chart.points.push_back(point);
  }
  chart.across = ChartAcross::time;
  summarise(chart, ErrorMetric::rmse);
  EXPECT_TRUE(chart.points[1].placed());
  chart.across = ChartAcross::work;
  summarise(chart, ErrorMetric::rmse);
  EXPECT_TRUE(chart.points[0].placed());
  EXPECT_FALSE(chart.points[1].placed());
  EXPECT_FALSE(chart.points[1].on_front);
}

}  // namespace
