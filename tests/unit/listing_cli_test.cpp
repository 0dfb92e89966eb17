// pixelscope-cli listing: a copy that a teacher checks from the command line.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/read_file.h"
#include "support/own_listings.h"

namespace ps::listing_cli_test {
namespace {
using test::run_cli;
using test::run_cli_well;

TEST(ListingCli, CopiesAndChecks) {
  test::OwnListings own;
  const auto copied = run_cli_well({"listing", "copy", "cgfs_06_lines"});
  const std::string file = copied.out.substr(0, copied.out.size() - 1);
  const auto checked = run_cli({"listing", "run", file, "--pixel", "300,299"});
  EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
  EXPECT_NE(checked.out.find("to the bit"), std::string::npos) << checked.out;
  EXPECT_NE(checked.out.find("draw_line(canvas, p0, p1, line->colour"), std::string::npos) << checked.out;

  const std::string wrong =
      own.folder().write("wrong.cpp", test::with_change(read_whole_file(file), "const double y = entry(ys, x, p0.x);",
                                                        "const double y = entry(ys, x, p0.y + nothing);"));
  const auto faulty = run_cli({"listing", "run", wrong});
  EXPECT_EQ(faulty.status, 1);
  EXPECT_NE(faulty.out.find("wrong.cpp:"), std::string::npos) << faulty.out;
  EXPECT_NE(faulty.out.find("nothing"), std::string::npos) << faulty.out;
}

/// The lesson begins with spheres, of which this listing shows nothing: all pictures would be alike.
TEST(ListingCli, TakesASceneThatTheListingShows) {
  test::OwnListings own;
  const auto copied = run_cli_well({"listing", "copy", "cgfs_15_shadows_in_the_rasterizer", "--without", "in_shadow"});
  const auto checked = run_cli({"listing", "run", copied.out.substr(0, copied.out.size() - 1)});
  EXPECT_EQ(checked.status, 1);
  EXPECT_NE(checked.out.find(" of 240000 pixels differ"), std::string::npos) << checked.out;
}

TEST(ListingCli, UnknownNamesAndFilesAreBadInput) {
  EXPECT_EQ(run_cli({"listing", "copy", "nonsense"}).status, 2);
  EXPECT_EQ(run_cli({"listing", "copy", "cgfs_06_lines", "--without", "nonsense"}).status, 2);
  EXPECT_EQ(run_cli({"listing", "run", "/nowhere/x.cpp"}).status, 2);
}

TEST(ListingCli, InspectPrintsLinesWithValues) {
  const auto text = run_cli_well({"inspect", "cgfs/spheres", "--pixel", "300,299", "--set", "renderer=textbook"});
  EXPECT_NE(text.out.find("discriminant = 0"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("[sphere red: 1 of 4]"), std::string::npos) << text.out;
  const auto json =
      run_cli_well({"inspect", "cgfs/spheres", "--pixel", "300,299", "--set", "renderer=textbook", "--json"});
  const auto story = nlohmann::json::parse(json.out);
  EXPECT_EQ(story.at("renderer"), "textbook");
  EXPECT_EQ(story.at("listing").at("folder"), "cgfs_02_basic_ray_tracing");
  EXPECT_GT(story.at("listing").at("values").size(), 10u);
}

}  // namespace
}  // namespace ps::listing_cli_test
