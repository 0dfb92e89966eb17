#include <gtest/gtest.h>

#include "options/option.h"
#include "support/option_contexts.h"

namespace ps {
namespace {

// A toggle that does nothing anywhere is a lie in the panel. Threads and SIMD change nothing but time, by design.
TEST(Options, EachChangesAPictureOrACounterSomewhere) {
  test::OptionResponses responses(96, 72);
  for (const Option& option : option_table()) {
    const bool only_time = option.key == "threads" || option.key == "simd";
    EXPECT_EQ(responses.find(option).has_value(), !only_time) << option.key;
  }
}

}  // namespace
}  // namespace ps
