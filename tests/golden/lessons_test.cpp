#include <gtest/gtest.h>

#include <regex>
#include <set>

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

  // A student who finds the right answer at one place may not expect the others there.
  const std::regex right(", choice ([0-9]+) of ");
  std::multiset<std::string> places;
  for (std::sregex_iterator each(result.out.begin(), result.out.end(), right); each != std::sregex_iterator(); ++each)
    places.insert((*each)[1]);
  if (places.size() >= 3) {
    EXPECT_LT(places.count(*places.begin()), places.size()) << "all right answers have place " << *places.begin();
  }
}

INSTANTIATE_TEST_SUITE_P(All, Lessons, testing::ValuesIn(lesson_names()), [](const auto& test) { return test.param; });

}  // namespace
}  // namespace ps
