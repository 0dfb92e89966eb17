// Scene files that include others.
#include <gtest/gtest.h>

#include "obj_corpus.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/refusal.h"

namespace scene_include_test {
namespace {

TEST(SceneInclude, InACircleIsRefused) {
  const ps::test::ModelFolder folder;
  folder.write("b.scene", "background = red\ninclude = \"a.scene\"\n");
  const std::string first = folder.write("a.scene", "# one\ninclude = b.scene\n");
  const std::string words = ps::test::refusal_of([&] { ps::load_scene(first); });
  EXPECT_TRUE(words.starts_with((folder.path() / "b.scene").string() + ":2:")) << words;
  EXPECT_TRUE(words.ends_with("expected a file that does not include this one")) << words;
}

TEST(SceneInclude, FilesAreListed) {
  const ps::test::ModelFolder folder;
  folder.write("parts/lamp.scene", "light { type = ambient intensity = 0.5 }\n");
  const std::string first = folder.write("room.scene", "include = parts/lamp.scene\n");
  const ps::Scene scene = ps::load_scene(first);
  EXPECT_EQ(scene.lights->size(), 1U);
  EXPECT_EQ(ps::files_of(scene), (std::vector<std::string>{first, (folder.path() / "parts/lamp.scene").string()}));
}

}  // namespace
}  // namespace scene_include_test
