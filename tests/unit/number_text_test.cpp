#include "base/number_text.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace {

using ps::parse_number;

TEST(NumberText, ReadsDecimalNumbersExactly) {
  EXPECT_EQ(parse_number("0"), 0.0);
  EXPECT_EQ(parse_number("-1.5"), -1.5);
  EXPECT_EQ(parse_number("+3"), 3.0);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("1e-3"), 1e-3);
  EXPECT_EQ(parse_number("0.1"), 0.1);
  EXPECT_EQ(parse_number("1.7976931348623157e308"), 1.7976931348623157e308);
  EXPECT_TRUE(std::signbit(*parse_number("-0")));
}

TEST(NumberText, RefusesAnythingElse) {
  for (const char* text :
       {"", " 1", "1 ", "1,5", "1.5f", "--1", "1e", "e5", "0x10", "inf", "nan", "NaN", "1e999", "-1e999", "1-2", "."})
    EXPECT_FALSE(parse_number(text).has_value()) << '\'' << text << '\'';
}

}  // namespace
