// What is rounded to float stays rounded: GCC 12 forgets it for pairs of numbers where it vectorises straight-line
// code, which cmake/Compiler.cmake therefore switches off.
#include <gtest/gtest.h>

#include <array>

namespace narrowing_test {
namespace {

using Pair = std::array<double, 2>;

void way_from_rounded(const Pair& target, const Pair& eye, std::array<float, 2>& way) {
  const float x = static_cast<float>(eye[0]), y = static_cast<float>(eye[1]);
  way[0] = static_cast<float>(target[0] - static_cast<double>(x));
  way[1] = static_cast<float>(target[1] - static_cast<double>(y));
}

TEST(Narrowing, RoundsPairsToo) {
  const double place = 1e5 + 0.123456, target = 1e5 + 1;
  volatile float rounded = static_cast<float>(place);
  std::array<float, 2> way{};
  void (*volatile run)(const Pair&, const Pair&, std::array<float, 2>&) = way_from_rounded;  // not folded away
  run({target, target}, {place, place}, way);
  EXPECT_EQ(way[0], static_cast<float>(target - static_cast<double>(rounded)));
  EXPECT_EQ(way[0], way[1]);
}

}  // namespace
}  // namespace narrowing_test
