// main() of every test program: runs the tests from the source folder, wherever it was started.
#include <gtest/gtest.h>

#include <filesystem>

int main(int argc, char** argv) {
  std::filesystem::current_path(PIXELSCOPE_SOURCE_DIR);  // first: parameters of tests may come from files
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
