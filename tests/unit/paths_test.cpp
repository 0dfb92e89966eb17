#include "base/paths.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace {

TEST(Paths, LieInTheSourceFolder) {
  unsetenv("PIXELSCOPE_ROOT");
  EXPECT_EQ(ps::asset_dir(), std::filesystem::current_path() / "assets");
  EXPECT_EQ(ps::chapter_dir(), std::filesystem::current_path() / "chapters");
}

TEST(Paths, FollowTheEnvironment) {
  setenv("PIXELSCOPE_ROOT", "/some/where", 1);
  EXPECT_EQ(ps::asset_dir(), "/some/where/assets");
  EXPECT_EQ(ps::chapter_dir(), "/some/where/chapters");
  unsetenv("PIXELSCOPE_ROOT");
}

}  // namespace
