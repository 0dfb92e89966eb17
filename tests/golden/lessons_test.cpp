#include <gtest/gtest.h>

#include "support/run_cli.h"

namespace ps {
namespace {

// Each claim must hold, and must fail once its option is reset: both is what `lessons check` checks.
TEST(Lessons, EveryClaimHoldsAndHasTeeth) {
  const auto result = test::run_cli({"lessons", "check"});
  EXPECT_EQ(result.status, 0) << result.out << result.err;
  EXPECT_NE(result.out.find(" 0 failed"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace ps
