// Why: at which stage of drawing triangles hardware and rasterizer part, as the window shows it.
#include <gtest/gtest.h>

#include <sstream>

#include "gui/program.h"
#include "support/golden.h"
#include "support/option_contexts.h"

namespace why_stages_test {
namespace {

TEST(WhyStages, ShowsTheCausesOfADifferenceAndTheirPixels) {
  if (!ps::test::has_renderer("hardware")) GTEST_SKIP() << "this build has no hardware renderer";
  const auto folder = ps::fresh_output_folder("gui-why-stages");
  const std::string fits = "wait idle\nprint window/cut\nprint window/overlap\n";
  const std::string commands = "wait idle\nkey Ctrl+K\nwait idle\ntype stages\nwait idle\nkey Enter\n" + fits +
                               "click why/set-up\nwait idle\nset shadows=none\nset-b shadows=none\nwait idle\n"
                               "click why/find\nwait idle\nexpect why/stages/whole 0\n"
                               "set-b mip-bias=2\nwait idle\nclick why/find\n" +
                               fits +
                               "expect why/stages/filtering > 500\nexpect why/stages/unexplained 0\nkeep pixel BEFORE\n"
                               "click why/stage/filtering\nwait idle\nexpect-not pixel $BEFORE\nkeep pixel BEFORE\n"
                               "click why/stages-map\nwait idle\nexpect-not pixel $BEFORE\n"
                               "click why/fill\n" +
                               fits + "quit\n";
  const auto result = ps::test::play(commands, folder, "1024x768", "cgfs/crates --size 60x60");
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_EQ(result.errors, "");
  std::istringstream lines(result.output);
  int printed = 0;
  for (std::string line; std::getline(lines, line); ++printed) EXPECT_EQ(line, "");
  EXPECT_EQ(printed, 6);
}

}  // namespace
}  // namespace why_stages_test
