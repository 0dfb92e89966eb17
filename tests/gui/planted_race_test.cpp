// The thread sanitizer looks at the window's threads: a race that is planted here must be reported, whatever is
// suppressed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

#include "base/sanitizers.h"

namespace planted_race_test {
namespace {

/// Two threads that write one number.
void race() {
  int shared = 0;
  std::thread other([&] { ++shared; });
  ++shared;
  other.join();
  std::exit(shared == 2 ? 0 : 1);
}

TEST(PlantedRace, IsReported) {
  if (!ps::with_thread_sanitizer) GTEST_SKIP() << "not built with the thread sanitizer";
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_DEATH(race(), "data race");
}

}  // namespace
}  // namespace planted_race_test
