// As the main() of a program that brings a renderer along: adds it, then runs the tests from the source folder.
#include <gtest/gtest.h>

#include <filesystem>

#include "constant_renderer.h"

int main(int argc, char** argv) {
  std::filesystem::current_path(PIXELSCOPE_SOURCE_DIR);
  ps::add_renderer(ps::test::constant_renderer());
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
