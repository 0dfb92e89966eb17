// Words of scene files: what one of them names is written with the same word again.
#include "scene/scene_keys.h"

#include <gtest/gtest.h>

#include "base/enumerators.h"
#include "document/permalink.h"
#include "options/choice_key.h"
#include "record/event_keys.h"
#include "scene/scene_file.h"
#include "scene/scene_writer.h"

namespace ps::scene_keys_test {
namespace {

TEST(SceneKeys, FormsHaveTheWordsOfTheBook) {
  for (const std::string_view key : {"sphere", "plane", "rectangle", "box", "cylinder"}) {
    ASSERT_TRUE(form_named(key)) << key;
    EXPECT_EQ(form_name(*form_named(key)), key);
  }
  EXPECT_TRUE(std::holds_alternative<Brick>(*form_named("box")));
  for (const std::string_view key : {"", "group", "brick", "Sphere"}) EXPECT_FALSE(form_named(key)) << key;
  EXPECT_EQ(operation_named("difference"), CsgOperation::difference);
  EXPECT_FALSE(operation_named("group"));
  EXPECT_EQ(enumerator_named<Sides>("front"), Sides::front);
  EXPECT_EQ(enumerator_named<Blend>("subtractive"), Blend::subtractive);
  EXPECT_FALSE(enumerator_named<Blend>("filter"));
}

TEST(SceneKeys, WrittenAsTheyAreRead) {
  const std::string text = R"(
box { name = "one"  center = (0, 0, 5)  size = (1, 2, 3)  rotation = <30 degrees around the Y axis>  sides = front }
cylinder { name = "two"  from = (0, 0, 5)  to = (0, 1, 5)  radius = 0.5 }
rectangle { name = "three"  corner = (0, 0, 5)  side_a = (1, 0, 0)  side_b = (0, 1, 0) }
plane { name = "four"  point = (0, -1, 0)  normal = (0, 1, 0) }
difference { name = "five"  sphere { center = (0, 0, 5)  radius = 1 }  box { center = (0, 0, 5)  size = 1 } }
line { from = (0, 0)  to = (1, 1)  color = (255, 0, 0)  blend = additive }
line { from = (0, 0)  to = (1, 1)  color = (255, 0, 0)  blend = subtractive }
line { from = (0, 0)  to = (1, 1)  color = (255, 0, 0)  blend = replace }
)";
  const Scene scene = parse_scene(text, "a.scene", ".");
  const std::string written = write_scene(scene, ".");
  const Scene again = parse_scene(written, "b.scene", ".");
  EXPECT_EQ(write_scene(again, "."), written);
  ASSERT_EQ(again.geometry->objects.size(), 5u) << written;
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(again.geometry->objects[i].shape, scene.geometry->objects[i].shape) << written;
  EXPECT_EQ(*again.canvas_items, *scene.canvas_items) << written;
  EXPECT_EQ(written.find("rotation = "), written.rfind("rotation = ")) << "the usual rotation is not named";
}

// The option table's keys, from the settings alone.
TEST(ChoiceKeys, AreThoseOfTheTable) {
  EXPECT_EQ(choice_key<&Settings::coverage>(Coverage::micropolygon), "micropolygon");
  EXPECT_EQ(choice_key<&Settings::renderer>(Renderer::textbook), "textbook");
  EXPECT_EQ(choice_key<&Settings::precision>(Precision::float64), "double");
  EXPECT_EQ(option_of<&Settings::near>().key, "near");
  EXPECT_EQ(event_key(CanvasFill::edges), "edge-functions") << "of the table, not of the enumerator";
  for (std::size_t i = 0; i < find_option("coverage")->choices.size(); ++i)
    EXPECT_EQ(event_key(static_cast<Coverage>(i)), find_option("coverage")->choices[i].key);
}

TEST(CompareKeys, AreReadAsTheyAreWritten) {
  for (const std::string_view key : {"side-by-side", "split", "difference", "only-a", "only-b"})
    EXPECT_EQ(enumerator_key(parse_enumerator<CompareMode>("compare", key)), key);
}

}  // namespace
}  // namespace ps::scene_keys_test
