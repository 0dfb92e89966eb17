#include "base/number_text.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <locale>
#include <optional>
#include <random>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/seeded_random.h"

namespace number_text_test {
namespace {

using ps::parse_integer;
using ps::parse_number;
using ps::parse_typed_number;
using ps::take_integer;
using ps::with_thousands;

struct CommaForPoint : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

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
  for (const char* text : {"", " 1", "1 ", "1,5", "1.5f", "--1", "1e", "e5", "0x10", "inf", "nan", "NaN", "1e400",
                           "0x1", "1e999", "-1e999", "1-2", "."})
    EXPECT_FALSE(parse_number(text).has_value()) << '\'' << text << '\'';
}

// The C library's strtod is another reader of the same notation; the text alone decides here, not the locale.
TEST(NumberText, AgreesWithTheCLibrary) {
  for (const char* text : {"1e-320", "4.9406564584124654e-324", "-2.2250738585072011e-308", "2.2250738585072014e-308",
                           "9007199254740993", "0.1e1", "+.5e+2", "5.", "1e-400", "-1e-400"}) {
    ASSERT_TRUE(parse_number(text)) << text;
    EXPECT_EQ(*parse_number(text), std::strtod(text, nullptr)) << text;
    EXPECT_EQ(std::signbit(*parse_number(text)), std::signbit(std::strtod(text, nullptr))) << text;
  }
  ps::test::SeededRandom random;
  for (int trial = 0; trial < 5000; ++trial) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    for (const char* form : {"{:.17g}", "{:.6g}", "{:.3e}"}) {
      const std::string text = fmt::format(fmt::runtime(form), value);
      const double expected = std::strtod(text.c_str(), nullptr);
      if (std::isfinite(expected))
        EXPECT_EQ(parse_number(text), expected) << text;
      else
        EXPECT_FALSE(parse_number(text)) << text;
    }
  }
}

// What looks like a number to a lenient reader: signs, dots and exponents in any order.
TEST(NumberText, TakesWhatTheCLibraryTakesWhole) {
  ps::test::SeededRandom random;
  const std::string letters = "+-.012e";
  std::uniform_int_distribution<std::size_t> letter(0, letters.size() - 1), length(1, 6);
  for (int trial = 0; trial < 20000; ++trial) {
    std::string text;
    for (std::size_t i = length(random); i > 0; --i) text += letters[letter(random)];
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    const bool whole = end == text.c_str() + text.size() && std::isfinite(value);
    EXPECT_EQ(parse_number(text), whole ? std::optional(value) : std::nullopt) << text;
  }
}

TEST(NumberText, CommasOfAPersonSetThousandsApart) {
  EXPECT_EQ(parse_typed_number("57,600"), 57600);
  EXPECT_EQ(parse_typed_number("-1,234,567.5"), -1234567.5);
  EXPECT_EQ(parse_typed_number("0.5"), 0.5);
  EXPECT_EQ(parse_typed_number("12e3"), 12000);
  for (const char* text :
       {"", ",", "1,5", "1,0000", "1,2345678", ",600", "1000,000", "1,,000", "1,000,", "0.5,000", "1,000e", "+,"})
    EXPECT_FALSE(parse_typed_number(text)) << text;
}

TEST(NumberText, ReadsWholeIntegers) {
  EXPECT_EQ(parse_integer<int>("-12"), -12);
  EXPECT_EQ(parse_integer<int>("007"), 7);
  EXPECT_EQ(parse_integer<unsigned>("fF", 16), 255u);
  EXPECT_EQ(parse_integer<std::uint64_t>("18446744073709551615"), 18446744073709551615u);
  for (const char* text : {"", "-", "+1", " 1", "1 ", "1.0", "1e3", "0x10", "5abc", "2147483648", "-2147483649"})
    EXPECT_FALSE(parse_integer<int>(text)) << '\'' << text << '\'';
  EXPECT_FALSE(parse_integer<unsigned>("-1"));
  EXPECT_FALSE(parse_integer<int>({}));
}

TEST(NumberText, TakesAnIntegerOffTheFront) {
  std::string_view text = "12:-5) rest";
  EXPECT_EQ(take_integer<int>(text), 12);
  EXPECT_EQ(text, ":-5) rest");
  EXPECT_FALSE(take_integer<int>(text));
  EXPECT_EQ(text, ":-5) rest") << "stays where there is no number";
  text.remove_prefix(1);
  EXPECT_FALSE(take_integer<unsigned>(text));
  EXPECT_EQ(take_integer<int>(text), -5);
  EXPECT_EQ(text, ") rest");
  text = "99999999999 more";
  EXPECT_FALSE(take_integer<int>(text));
  EXPECT_EQ(text, "99999999999 more") << "stays where the number does not fit";
}

TEST(NumberText, ThousandsAreApart) {
  EXPECT_EQ(with_thousands("999"), "999");
  EXPECT_EQ(with_thousands("1000"), "1,000");
  EXPECT_EQ(with_thousands("123456789"), "123,456,789");
}

TEST(NumberText, HasAPointInEveryLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaForPoint));
  EXPECT_EQ(parse_number("1.5"), 1.5);
  EXPECT_FALSE(parse_number("1,5"));
  std::locale::global(before);
}

}  // namespace
}  // namespace number_text_test
