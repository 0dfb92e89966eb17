#include <gtest/gtest.h>

#include <limits>

#include "record/value_text.h"

namespace against_text_test {
namespace {

TEST(AgainstText, ShowsAsManyDigitsAsDistinguishTheNumbers) {
  EXPECT_EQ(ps::against_text(2, 1.5), "2 against 1.5");
  EXPECT_EQ(ps::against_text(65534, 65533), "65534 against 65533") << "four digits would show 6.553e+04 twice";
  EXPECT_EQ(ps::against_text(65534, 65534), "65534 against the same");
  EXPECT_EQ(ps::against_text(static_cast<double>(0.1f), static_cast<double>(0.1f)), "0.100000001 against the same");
  EXPECT_EQ(ps::against_text(1, std::numeric_limits<double>::infinity()).substr(0, 10), "1 against ");
}

}  // namespace
}  // namespace against_text_test
