// main() of the test programs that link the renderers which programs add: as that of tests/support, with them.
#include <gtest/gtest.h>

#include <filesystem>

#include "added_renderers.h"

int main(int argc, char** argv) {
  std::filesystem::current_path(PIXELSCOPE_SOURCE_DIR);  // first: parameters of tests may come from files
  ps::add_renderers();
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
