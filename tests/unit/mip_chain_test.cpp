#include "image/mip_chain.h"

#include <gtest/gtest.h>

#include <random>

namespace mip_chain_test {
namespace {

using ps::Image;
using ps::Vec3d;
using ps::Vec3f;

std::shared_ptr<const Image<Vec3f>> noise_texture(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> values(0, 1);
  Image<Vec3f> image(width, height);
  for (Vec3f& p : image.pixels()) p = {values(random), values(random), values(random)};
  return std::make_shared<const Image<Vec3f>>(std::move(image));
}

Vec3d mean(const Image<Vec3f>& image) {
  Vec3d sum(0);
  for (const Vec3f& p : image.pixels()) sum += Vec3d(p);
  return sum / static_cast<double>(image.pixels().size());
}

TEST(MipChain, HalvesDownToOneTexel) {
  const auto sizes = [](int width, int height) {
    const auto chain = ps::make_mip_chain(noise_texture(width, height, 1));
    std::vector<std::pair<int, int>> result;
    result.reserve(static_cast<std::size_t>(chain.levels()));
    for (int i = 0; i < chain.levels(); ++i) result.emplace_back(chain.level(i).width(), chain.level(i).height());
    return result;
  };
  using Sizes = std::vector<std::pair<int, int>>;
  EXPECT_EQ(sizes(8, 8), (Sizes{{8, 8}, {4, 4}, {2, 2}, {1, 1}}));
  EXPECT_EQ(sizes(7, 3), (Sizes{{7, 3}, {3, 1}, {1, 1}}));
  EXPECT_EQ(sizes(1, 5), (Sizes{{1, 5}, {1, 2}, {1, 1}}));
  EXPECT_EQ(sizes(1, 1), (Sizes{{1, 1}}));
  EXPECT_EQ(ps::make_mip_chain(noise_texture(8, 8, 1), ps::MipLevels::finest_only).levels(), 1);
}

TEST(MipChain, ATexelIsTheMeanOfTheFourBelowIt) {
  Image<Vec3f> base(4, 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 4; ++x) base.at(x, y) = Vec3f(static_cast<float>(x + 4 * y));
  const auto chain = ps::make_mip_chain(std::make_shared<const Image<Vec3f>>(base));
  EXPECT_EQ(chain.level(1).at(0, 0), Vec3f(2.5f));  // 0 1 4 5
  EXPECT_EQ(chain.level(1).at(1, 0), Vec3f(4.5f));  // 2 3 6 7
  EXPECT_EQ(chain.level(2).at(0, 0), Vec3f(3.5f));
}

TEST(MipChain, OddSizesShareTheMiddleTexel) {
  Image<Vec3f> base(3, 1);
  base.at(0, 0) = Vec3f(3);
  base.at(1, 0) = Vec3f(6);
  base.at(2, 0) = Vec3f(12);
  EXPECT_FLOAT_EQ(ps::make_mip_chain(std::make_shared<const Image<Vec3f>>(base)).level(1).at(0, 0).r, 7);

  Image<Vec3f> five(5, 1);
  for (int x = 0; x < 5; ++x) five.at(x, 0) = Vec3f(static_cast<float>(x == 2));
  const auto chain = ps::make_mip_chain(std::make_shared<const Image<Vec3f>>(five));
  EXPECT_FLOAT_EQ(chain.level(1).at(0, 0).r, 0.2f);  // half of the texel, out of two and a half
  EXPECT_FLOAT_EQ(chain.level(1).at(1, 0).r, 0.2f);
}

TEST(MipChain, EveryLevelHasTheMeanOfTheTexture) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  for (const auto& [width, height] : {std::pair{64, 64}, {63, 61}, {100, 7}, {1, 33}, {600, 600}}) {
    const auto base = noise_texture(width, height, seed);
    const auto chain = ps::make_mip_chain(base);
    const Vec3d expected = mean(*base);
    for (int i = 1; i < chain.levels(); ++i) {
      const Vec3d found = mean(chain.level(i));
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(found[c], expected[c], 1e-6) << width << " x " << height << ", level " << i;
    }
  }
}

}  // namespace
}  // namespace mip_chain_test
