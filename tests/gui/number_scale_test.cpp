#include <gtest/gtest.h>

#include <random>

#include "gui/widgets/number_scale.h"
#include "options/option.h"

namespace number_scale_test {
namespace {

using namespace ps::gui;

NumberRange range_of(const ps::Option& option) {
  return {option.minimum, option.maximum, option.scale, option.kind == ps::OptionKind::integer, option.unit};
}

TEST(NumberScale, EndsAndOrderHoldForEveryOption) {
  for (const ps::Option& option : ps::option_table()) {
    if (option.kind != ps::OptionKind::integer && option.kind != ps::OptionKind::real) continue;
    const NumberRange range = range_of(option);
    EXPECT_EQ(slider_value(0, range), option.minimum) << option.key;
    EXPECT_EQ(slider_value(1, range), option.maximum) << option.key;
    double before = option.minimum;
    for (int i = 0; i <= 1000; ++i) {
      const double value = slider_value(i / 1000.0, range);
      EXPECT_GE(value, before) << option.key;
      EXPECT_LE(value, option.maximum) << option.key;
      if (range.integer) {
        EXPECT_EQ(value, std::round(value)) << option.key;
      }
      // Going back by position finds the value again, within the rounding to three digits.
      EXPECT_NEAR(slider_position(value, range), i / 1000.0, range.integer ? 1 : 0.01) << option.key << " " << value;
      before = value;
    }
  }
}

TEST(NumberScale, WheelStepsAreRoundAndReversible) {
  const NumberRange epsilon{0, 10, ps::OptionScale::logarithmic, false, {}};
  EXPECT_EQ(stepped_value(0.001, 1, epsilon), 0.002);
  EXPECT_EQ(stepped_value(0.002, 1, epsilon), 0.005);
  EXPECT_EQ(stepped_value(0.005, 1, epsilon), 0.01);
  EXPECT_EQ(stepped_value(0.001, -1, epsilon), 0.0005);
  EXPECT_EQ(stepped_value(0.0015, -1, epsilon), 0.001);
  EXPECT_EQ(stepped_value(10, 3, epsilon), 10);
  EXPECT_EQ(stepped_value(0, 1, epsilon), 1e-7);
  EXPECT_EQ(stepped_value(1e-7, -1, epsilon), 0);
  const NumberRange depth{0, 64, ps::OptionScale::linear, true, {}};
  EXPECT_EQ(stepped_value(3, 1, depth), 4);
  EXPECT_EQ(stepped_value(0, -1, depth), 0);
  EXPECT_EQ(stepped_value(64, 1, depth), 64);
}

TEST(NumberScale, TypedNumbersAreReadWhole) {
  const NumberRange range{-10, 100000, ps::OptionScale::linear, false, {}};
  const NumberRange whole{0, 10, ps::OptionScale::linear, true, {}};
  EXPECT_EQ(typed_value("0.25", range), 0.25);
  EXPECT_EQ(typed_value("  -2.5e0 ", range), -2.5);
  EXPECT_EQ(typed_value("57,600", range), 57600);
  EXPECT_EQ(typed_value("1e9", range), 100000) << "kept in the range";
  EXPECT_EQ(typed_value("2.6", whole), 3);
  for (const char* text : {"", "   ", "5abc", "5 6", "1,5", "inf", "nan", "0x10"})
    EXPECT_FALSE(typed_value(text, range)) << '\'' << text << '\'';
}

TEST(NumberText, FourSignificantDigits) {
  EXPECT_EQ(short_number(0.001), "0.001");
  EXPECT_EQ(short_number(3.14159265), "3.142");
  EXPECT_EQ(short_number(1234.5678), "1235");
  EXPECT_EQ(short_number(12.5), "12.5");
  EXPECT_EQ(short_number(0.30000000000000004), "0.3");
  EXPECT_EQ(short_number(1e-9), "1.000e-09");
  EXPECT_EQ(short_number(5000), "5000");
  EXPECT_EQ(short_number(-0.25), "-0.25");
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const double value =
        std::ldexp(std::uniform_real_distribution<>(-1, 1)(random), static_cast<int>(random() % 40) - 20);
    EXPECT_NEAR(std::stod(short_number(value)), value, std::abs(value) * 5.1e-4);
    EXPECT_EQ(std::stod(full_number(value)), value);
  }
}

}  // namespace
}  // namespace number_scale_test
