#include <gtest/gtest.h>

#include "options/option.h"
#include "raytrace/wide_search.h"
#include "support/option_contexts.h"

namespace ps {
namespace {

// A toggle that does nothing anywhere is a lie in the panel. Threads change nothing but time, by design. SIMD searches
// triangles in a tree of its own, so it changes counters, on processors that it covers; cached constants belong to it.
TEST(Options, EachChangesAPictureOrACounterSomewhere) {
  test::OptionResponses responses(96, 72);
  for (const Option& option : option_table()) {
    const bool has_simd = wide_searches(Simd::automatic, TriangleTest::watertight).nearest != nullptr;
    const bool needs_simd = option.key == "simd" || option.key == "cache-constants";
    const bool only_time = option.key == "threads" || (needs_simd && !has_simd);
    EXPECT_EQ(responses.find(option).has_value(), !only_time) << option.key;
  }
}

}  // namespace
}  // namespace ps
