#include "scene/scene_writer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "obj_corpus.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "scene_random.h"

namespace scene_writer_test {
namespace {

TEST(SceneWriter, BuiltInScenesReadBackTheSame) {
  const ps::test::ModelFolder folder;
  for (const auto& listed : ps::builtin_scenes()) {
    SCOPED_TRACE(listed.name);
    const ps::Scene scene = ps::load_scene(listed.name);
    const auto path = folder.path() / "saved.scene";
    ps::save_scene(scene, path);
    ps::test::expect_equal_scenes(scene, ps::load_scene(path.string()));
  }
}

TEST(SceneWriter, RandomScenesReadBackTheSame) {
  const std::uint64_t seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 300 && !testing::Test::HasFailure(); ++i) {
    const ps::Scene scene = ps::test::scene_with_everything(random);
    const std::string text = ps::write_scene(scene, ".");
    SCOPED_TRACE(text);
    try {
      ps::test::expect_equal_scenes(scene, ps::parse_scene(text, "random.scene", "."));
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

// The comparison above must be able to fail.
TEST(SceneWriter, ADifferenceInTheLastBitIsSeen) {
  ps::Scene scene = ps::load_scene("cgfs/reflections");
  ps::Scene changed = scene;
  changed.materials.edit(
      [](std::vector<ps::Material>& materials) { materials[1].colour.y = std::nextafter(materials[1].colour.y, 0); });
  EXPECT_NE(ps::write_scene(scene, "."), ps::write_scene(changed, "."));
  ps::test::expect_equal_scenes(changed, ps::parse_scene(ps::write_scene(changed, "."), "x.scene", "."));
}

TEST(SceneWriter, SpheresKeepTheBooksForm) {
  const std::string text = ps::write_scene(ps::load_scene("cgfs/reflections"), ".");
  EXPECT_NE(text.find("sphere {\n    name = red\n    center = (0, -1, 3)\n    radius = 1\n    color = (255, 0, 0)\n"
                      "    specular = 500\n    reflective = 0.2\n}"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace scene_writer_test
