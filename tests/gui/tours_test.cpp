// app/run plays the first tour where there is no display: each tour ends well, and leaves all of its pictures.
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <regex>

#include "gui/program.h"
#include "support/golden.h"

namespace tours_test {
namespace {

TEST(Tours, EachPlaysToItsEnd) {
  int played = 0;
  for (const auto& entry : std::filesystem::directory_iterator("assets/tours")) {
    if (entry.path().extension() != ".tour") continue;
    SCOPED_TRACE(entry.path());
    const auto folder = std::filesystem::absolute(ps::fresh_output_folder("gui-" + entry.path().stem().string()));
    const std::string tour = ps::test::read_file(entry.path());
    const auto result =
        ps::test::play_by_hand(std::regex_replace(tour, std::regex(" out/"), " " + folder.string() + "/"), {}, folder);
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
    std::ptrdiff_t pictures = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder))
      pictures += file.path().extension() == ".png" ? 1 : 0;
    const std::regex screenshot("screenshot");
    EXPECT_EQ(pictures, std::distance(std::sregex_iterator(tour.begin(), tour.end(), screenshot), {}));
    EXPECT_GT(pictures, 0);
    ++played;
  }
  EXPECT_GT(played, 0);
}

}  // namespace
}  // namespace tours_test
