// How a listing's lines are broken where they are longer than their place.
#include "gui/panels/story/code_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace code_lines_test {
namespace {

using ps::gui::code_lines;

TEST(CodeLines, BreakAtBlanksAndIndentWhatGoesOn) {
  EXPECT_EQ(code_lines("  const int a = b + c;", 16), "  const int a =\n      b + c;");
  EXPECT_EQ(code_lines("  const int a = b;", 18), "  const int a = b;");
}

TEST(CodeLines, AWordThatFitsWithLessInFrontStaysWhole) {
  EXPECT_EQ(code_lines("int column = static_cast<int>(x);", 20), "int column =\nstatic_cast<int>(x);");
}

TEST(CodeLines, AWordLongerThanALineIsBrokenBehindABracket) {
  EXPECT_EQ(code_lines("int column = static_cast<int>(std::floor(seen.x));", 26),
            "int column =\n    static_cast<int>(std::\n    floor(seen.x));");
}

std::string without_blanks(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
  return text;
}

TEST(CodeLines, OfEveryListingFitAndLoseNothing) {
  int seen = 0;
  for (const auto& chapter : std::filesystem::directory_iterator("chapters")) {
    std::ifstream listing(chapter.path() / "listing.cpp");
    for (std::string line; std::getline(listing, line); ++seen)
      for (const std::size_t characters : {12u, 24u, 26u, 37u, 60u}) {
        const std::string broken = code_lines(line, characters);
        EXPECT_EQ(without_blanks(broken), without_blanks(line));
        std::istringstream parts(broken);
        for (std::string part; std::getline(parts, part);) EXPECT_LE(part.size(), characters) << line;
      }
  }
  EXPECT_GT(seen, 2000);
}

}  // namespace
}  // namespace code_lines_test
