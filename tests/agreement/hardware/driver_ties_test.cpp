// Samples exactly on an edge. A driver gives them to the same triangle as the rasterizer, except where it cuts a
// triangle at the border of the picture and rounds the vertices that this makes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "agreement/hardware/driver_ties.h"
#include "agreement/hardware/hardware_pair.h"
#include "hardware/gl_thread.h"

namespace ps {
namespace {

test::TieCount counted(test::Reach reach, Renderer hardware) {
  const test::TieCount count = test::count_ties(reach, hardware);
  fmt::print("{} of {} samples differ, at most {:.5f} pixels from an edge; {} ties\n", count.differ, count.covered,
             count.farthest, count.ties);
  return count;
}

TEST(HardwareTies, WithinThePictureNoneDiffers) {
  PS_NEEDS_HARDWARE(hardware);
  const test::TieCount count = counted(test::Reach::within_picture, hardware);
  EXPECT_GT(count.covered, 100000);
  EXPECT_GT(count.ties, 500);
  EXPECT_EQ(count.differ, 0);
}

TEST(HardwareTies, BeyondItOnlySamplesWithinASubPixelOfAnEdgeDiffer) {
  PS_NEEDS_HARDWARE(hardware);
  const test::TieCount count = counted(test::Reach::beyond_it, hardware);
  EXPECT_GT(count.covered, 100000);
  EXPECT_LE(count.differ, count.covered / 1000);
  EXPECT_LE(count.farthest, std::exp2(-hardware::availability().driver->subpixel_bits));
}

}  // namespace
}  // namespace ps
