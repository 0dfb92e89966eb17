#include "base/resources.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace resources_test {
namespace {

TEST(Resources, LieInTheSourceFolder) {
  unsetenv("PIXELSCOPE_ROOT");
  EXPECT_EQ(ps::asset_dir(), std::filesystem::current_path() / "assets");
  EXPECT_EQ(ps::chapter_dir(), std::filesystem::current_path() / "chapters");
  EXPECT_TRUE(std::filesystem::exists(ps::scene_dir() / "cgfs" / "reflections.scene"));
  EXPECT_TRUE(std::filesystem::exists(ps::lesson_file("cgfs_13_shading")));
  EXPECT_TRUE(std::filesystem::exists(ps::listing_file("cgfs_13_shading")));
}

TEST(Resources, FollowTheEnvironment) {
  setenv("PIXELSCOPE_ROOT", "/some/where", 1);
  EXPECT_EQ(ps::asset_dir(), "/some/where/assets");
  EXPECT_EQ(ps::scene_dir(), "/some/where/assets/scenes");
  EXPECT_EQ(ps::chapter_dir(), "/some/where/chapters");
  EXPECT_EQ(ps::lesson_file("cgfs_06_lines"), "/some/where/chapters/cgfs_06_lines/lesson.md");
  EXPECT_EQ(ps::listing_file("cgfs_06_lines"), "/some/where/chapters/cgfs_06_lines/listing.cpp");
  unsetenv("PIXELSCOPE_ROOT");
}

}  // namespace
}  // namespace resources_test
