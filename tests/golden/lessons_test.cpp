#include <gtest/gtest.h>

#include "engine/lesson.h"
#include "support/run_cli.h"

namespace ps {
namespace {

class Lessons : public testing::TestWithParam<std::string> {};

// Each claim must hold, and must fail once its option is reset: both is what `lessons check` checks.
TEST_P(Lessons, EveryClaimHoldsAndHasTeeth) {
  const auto result = test::run_cli({"lessons", "check", GetParam()});
  EXPECT_EQ(result.status, 0) << result.out << result.err;
  EXPECT_NE(result.out.find(" 0 failed"), std::string::npos) << result.out;
}

INSTANTIATE_TEST_SUITE_P(All, Lessons, testing::ValuesIn(lesson_names()), [](const auto& test) { return test.param; });

}  // namespace
}  // namespace ps
