// The claims of the lesson that needs a graphics driver.
#include <gtest/gtest.h>

#include "agreement/hardware/hardware_pair.h"
#include "engine/lesson.h"
#include "support/run_cli.h"

namespace ps::hardware_lesson_test {
namespace {

TEST(HardwareLesson, EveryClaimHoldsAndHasTeeth) {
  PS_NEEDS_HARDWARE(hardware);
  const std::string lesson = "cgpp_15_7_the_hardware_pipeline";
  EXPECT_FALSE(why_not_here(load_lesson(lesson)));
  const auto result = test::run_cli({"lessons", "check", lesson});
  EXPECT_EQ(result.status, 0) << result.out << result.err;
  EXPECT_NE(result.out.find(" 0 failed"), std::string::npos) << result.out;
  EXPECT_EQ(result.out.find("not checked"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace ps::hardware_lesson_test
