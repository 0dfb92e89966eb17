// What a student's program writes, read as if an enemy had written it.
#include "student/result_bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "base/check.h"
#include "support/refusal.h"

namespace ps::own_result_test {
namespace {

const ListingTask both{.picture = true, .traced = Vec2i{1, 0}};

OwnResult sample() {
  OwnResult result;
  result.picture = Image<Vec3d>(3, 2, Vec3d(1, 2, 3));
  result.picture.at(2, 1).y = std::numeric_limits<double>::quiet_NaN();
  OwnTrace trace;
  trace.colour = {4, 5, 6};
  trace.instances = {{7, "sphere", std::string("red"), -1}, {8, "light", std::int64_t{2}, 0}};
  trace.watches = {{9, "t", 0.5, 1}, {9, "v", Vec3d(1, 2, 3), 0}, {10, "b", true, -1}, {11, "p", Vec2d(1, 2), -1}};
  trace.dropped = 12;
  result.trace = trace;
  return result;
}

std::string refusal(const std::string& bytes, const ListingTask& task = both) {
  return test::refusal_of([&] { parse_result(bytes, 3, 2, task); });
}

/// The bytes with a number at a place replaced.
std::string with_number(std::string bytes, std::size_t at, std::int32_t number) {
  std::memcpy(bytes.data() + at, &number, sizeof number);
  return bytes;
}

TEST(OwnResult, ComesBackAsItWas) {
  const OwnResult read = parse_result(result_bytes(sample()), 3, 2, both);
  EXPECT_EQ(read.picture.at(0, 0), Vec3d(1, 2, 3));
  EXPECT_TRUE(std::isnan(read.picture.at(2, 1).y));
  ASSERT_TRUE(read.trace);
  EXPECT_EQ(read.trace->instances, sample().trace->instances);
  EXPECT_EQ(read.trace->watches, sample().trace->watches);
  EXPECT_EQ(read.trace->dropped, 12u);
  EXPECT_LE(result_bytes(sample()).size(), most_result_bytes(3, 2, both));
}

TEST(OwnResult, EachShorterOneIsRefusedAndALongerOneToo) {
  const std::string bytes = result_bytes(sample());
  for (std::size_t size = 0; size < bytes.size(); ++size) EXPECT_NE(refusal(bytes.substr(0, size)), "") << size;
  EXPECT_NE(refusal(bytes + "x").find("1 bytes too many"), std::string::npos);
}

TEST(OwnResult, WhatWasNotAskedForIsRefused) {
  const std::string bytes = result_bytes(sample());
  EXPECT_EQ(refusal(bytes), "");
  EXPECT_NE(refusal(bytes, {.picture = true, .traced = {}}), "");
  EXPECT_NE(refusal(bytes, {.picture = false, .traced = Vec2i{0, 0}}).find("expected one of 0 x 0"), std::string::npos);
  EXPECT_THROW(parse_result(bytes, 2, 3, both), InputError);
}

/// The places follow from result_bytes(): mark, width, height, six colours, a mark, a colour, the number of instances.
TEST(OwnResult, NumbersOutsideTheirRangeAreRefused) {
  const std::string bytes = result_bytes(sample());
  const std::size_t instances = 12 + 6 * 24 + 1 + 24, first_line = instances + 4, first_parent = first_line + 4;
  EXPECT_NE(refusal(with_number(bytes, 4, 1 << 30)).find("1073741824 x 2"), std::string::npos);
  EXPECT_NE(refusal(with_number(bytes, 4, -3)), "");
  EXPECT_NE(refusal(with_number(bytes, instances, 10'001)).find("10001 instances"), std::string::npos);
  EXPECT_NE(refusal(with_number(bytes, instances, -1)), "");
  EXPECT_NE(refusal(with_number(bytes, first_line, -1)), "");
  EXPECT_NE(refusal(with_number(bytes, first_parent, 0)).find("a parent 0"), std::string::npos);  // itself
  EXPECT_NE(refusal(with_number(bytes, first_parent, -2)), "");
  EXPECT_NE(refusal(with_number(bytes, first_parent + 4, 1 << 30)).find("text that is too long"), std::string::npos);
  std::string kind = bytes;
  kind[first_parent + 4 + 4 + 6] = 6;  // behind the name "sphere"
  EXPECT_NE(refusal(kind).find("unknown kind"), std::string::npos);
}

}  // namespace
}  // namespace ps::own_result_test
