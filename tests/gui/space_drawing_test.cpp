// The space view as a file shows what the window shows.
#include <gtest/gtest.h>

#include <filesystem>

#include "gui/program.h"
#include "support/golden.h"

namespace space_drawing_test {
namespace {

std::size_t lines_of(const std::string& svg) {
  std::size_t count = 0;
  for (auto at = svg.find("<line "); at != std::string::npos; at = svg.find("<line ", at + 1)) ++count;
  return count;
}

// Up to the first event there is the eye ray, and nothing that comes after it.
TEST(SpaceDrawing, HoldsWhatHasHappenedSoFar) {
  const auto folder = ps::fresh_output_folder("gui-space-drawing");
  const auto save = [&](const std::string& name) {
    return "click space/svg\nwait frames 3\ntype " + std::filesystem::absolute(folder / name).string() +
           "\nkey Enter\nwait idle\n";
  };
  const auto run = ps::test::play("wait idle\nclick bottom/space\nwait idle\n" + save("whole.svg") +
                                      "key .\nwait idle\n" + save("first.svg") + "quit\n",
                                  folder, "1024x768", "cgfs/reflections");
  ASSERT_EQ(run.status, 0) << run.errors;
  const std::string whole = ps::test::read_file(folder / "whole.svg");
  const std::string first = ps::test::read_file(folder / "first.svg");
  EXPECT_GT(lines_of(first), 0u);
  EXPECT_LT(lines_of(first), lines_of(whole));
  EXPECT_NE(whole.find("#56b4e9"), std::string::npos) << "a reflected ray is sky blue";
  EXPECT_EQ(first.find("#56b4e9"), std::string::npos);
}

}  // namespace
}  // namespace space_drawing_test
