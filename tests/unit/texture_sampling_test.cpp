#include "image/texture_sampling.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "image/mip_level.h"

namespace texture_sampling_test {
namespace {

using ps::Image;
using ps::MipChain;
using ps::Texel;
using ps::TextureFilter;
using ps::TextureWrap;
using ps::Vec2;
using ps::Vec3;
using ps::Vec3d;
using ps::Vec3f;

MipChain noise_chain(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> values(0, 1);
  Image<Vec3f> image(width, height);
  for (Vec3f& p : image.pixels()) p = {values(random), values(random), values(random)};
  return ps::make_mip_chain(std::make_shared<const Image<Vec3f>>(std::move(image)));
}

/// Red is the column, green the row.
Image<Vec3f> coordinates(int width, int height) {
  Image<Vec3f> image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.at(x, y) = {static_cast<float>(x), static_cast<float>(y), 0};
  return image;
}

template <class Real>
class TextureSampling : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(TextureSampling, Reals);

TYPED_TEST(TextureSampling, NearestTakesTheTexelThatHoldsThePoint) {
  using V = Vec2<TypeParam>;
  const auto image = coordinates(4, 2);
  const auto at = [&](double u, double v, TextureWrap wrap) {
    return ps::sample_nearest(image, V(static_cast<TypeParam>(u), static_cast<TypeParam>(v)), wrap);
  };
  using C = Vec3<TypeParam>;
  EXPECT_EQ(at(0, 0, TextureWrap::repeat), C(0, 0, 0));
  EXPECT_EQ(at(0.2499, 0.4999, TextureWrap::repeat), C(0, 0, 0));
  EXPECT_EQ(at(0.25, 0.5, TextureWrap::repeat), C(1, 1, 0));
  EXPECT_EQ(at(0.9999, 0.9999, TextureWrap::repeat), C(3, 1, 0));
  EXPECT_EQ(at(1, 1, TextureWrap::repeat), C(0, 0, 0));
  EXPECT_EQ(at(1, 1, TextureWrap::clamp), C(3, 1, 0));
  EXPECT_EQ(at(1, 1, TextureWrap::mirror), C(3, 1, 0));
  EXPECT_EQ(at(1.3, -0.1, TextureWrap::repeat), C(1, 1, 0));
  EXPECT_EQ(at(1.3, -0.1, TextureWrap::clamp), C(3, 0, 0));
  EXPECT_EQ(at(1.3, -0.1, TextureWrap::mirror), C(2, 0, 0));
  EXPECT_EQ(at(-7.6, 5.9, TextureWrap::repeat), C(1, 1, 0));
  EXPECT_EQ(at(-7.6, 5.9, TextureWrap::mirror), C(1, 0, 0));  // 7.6 mirrored is 8 - 7.6 = 0.4; 5.9 is 0.1
}

TYPED_TEST(TextureSampling, BilinearIsExactAtTexelCentresAndHalfwayBetween) {
  using V = Vec2<TypeParam>;
  const auto chain = noise_chain(8, 4, 7);
  const auto& image = *chain.base;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 8; ++x) {
      const V centre((static_cast<TypeParam>(x) + TypeParam(0.5)) / 8,
                     (static_cast<TypeParam>(y) + TypeParam(0.5)) / 4);
      for (const auto wrap : {TextureWrap::repeat, TextureWrap::clamp, TextureWrap::mirror})
        EXPECT_EQ(ps::sample_bilinear(image, centre, wrap), Vec3<TypeParam>(image.at(x, y)));
    }
  }
  // The corner shared by four texels is their mean.
  const auto mean =
      (Vec3d(image.at(2, 1)) + Vec3d(image.at(3, 1)) + Vec3d(image.at(2, 2)) + Vec3d(image.at(3, 2))) / 4.0;
  const auto found = ps::sample_bilinear(image, V(TypeParam(3) / 8, TypeParam(2) / 4), TextureWrap::repeat);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(static_cast<double>(found[c]), mean[c], 1e-7);
}

TYPED_TEST(TextureSampling, BilinearIsLinearInside) {
  using V = Vec2<TypeParam>;
  const auto image = coordinates(16, 8);
  for (int i = 0; i <= 100; ++i) {
    const double u = (0.5 + 15.0 * i / 100) / 16;
    const double v = (0.5 + 7.0 * i / 100) / 8;
    const auto found =
        ps::sample_bilinear(image, V(static_cast<TypeParam>(u), static_cast<TypeParam>(v)), TextureWrap::clamp);
    EXPECT_NEAR(static_cast<double>(found.r), u * 16 - 0.5, 1e-5);
    EXPECT_NEAR(static_cast<double>(found.g), v * 8 - 0.5, 1e-5);
  }
}

TYPED_TEST(TextureSampling, BordersFollowTheWrap) {
  using V = Vec2<TypeParam>;
  const auto image = coordinates(4, 1);
  const auto red = [&](double u, TextureWrap wrap) {
    return static_cast<double>(ps::sample_bilinear(image, V(static_cast<TypeParam>(u), TypeParam(0.5)), wrap).r);
  };
  EXPECT_EQ(red(0, TextureWrap::repeat), 1.5);  // half of the last texel, half of the first
  EXPECT_EQ(red(1, TextureWrap::repeat), 1.5);
  EXPECT_EQ(red(0, TextureWrap::clamp), 0);
  EXPECT_EQ(red(1, TextureWrap::clamp), 3);
  EXPECT_EQ(red(0, TextureWrap::mirror), 0);
  EXPECT_EQ(red(1, TextureWrap::mirror), 3);
  EXPECT_EQ(red(-0.25, TextureWrap::repeat), 2.5);
  EXPECT_EQ(red(-0.25, TextureWrap::clamp), 0);
  EXPECT_EQ(red(-0.25, TextureWrap::mirror), 0.5);
  EXPECT_EQ(red(1.25, TextureWrap::mirror), 2.5);
  EXPECT_EQ(red(2.25, TextureWrap::mirror), 0.5);
}

TYPED_TEST(TextureSampling, OddCoordinatesStayInside) {
  using V = Vec2<TypeParam>;
  using Limits = std::numeric_limits<TypeParam>;
  const auto chain = noise_chain(5, 3, 11);
  for (const TypeParam u : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::max(),
                            Limits::lowest(), -Limits::denorm_min(), -Limits::epsilon(), TypeParam(1e9)}) {
    for (const auto wrap : {TextureWrap::repeat, TextureWrap::clamp, TextureWrap::mirror}) {
      for (const auto filter :
           {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::mipmap, TextureFilter::trilinear}) {
        for (const TypeParam level : {TypeParam(0), TypeParam(1.5), Limits::quiet_NaN(), Limits::infinity()}) {
          std::vector<Texel> texels;
          const auto sample = ps::sample_texture<TypeParam>(chain, V(u, u), {filter, wrap, level}, &texels);
          EXPECT_EQ(texels.size(), static_cast<std::size_t>(sample.texels));
          for (const Texel& texel : texels) EXPECT_TRUE(chain.level(texel.level).contains(texel.x, texel.y));
          EXPECT_TRUE(sample.colour.r >= 0 && sample.colour.r <= 1);
        }
      }
    }
  }
}

// What is noted for the inspector must make the colour.
TYPED_TEST(TextureSampling, NotedTexelsAddUpToTheColour) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-3, 3), level(-1, 7);
  const auto chain = noise_chain(37, 64, seed);
  for (int i = 0; i < 2000; ++i) {
    const Vec2<TypeParam> uv(static_cast<TypeParam>(coordinate(random)), static_cast<TypeParam>(coordinate(random)));
    const auto filter = static_cast<TextureFilter>(i % 4);
    const auto wrap = static_cast<TextureWrap>(i / 4 % 3);
    std::vector<Texel> texels;
    const ps::TextureLookup<TypeParam> lookup{filter, wrap, static_cast<TypeParam>(level(random))};
    const auto sample = ps::sample_texture(chain, uv, lookup, &texels);
    EXPECT_EQ(sample.colour, ps::sample_texture(chain, uv, lookup).colour);
    ASSERT_EQ(texels.size(), static_cast<std::size_t>(sample.texels));
    Vec3d sum(0);
    double weights = 0;
    for (const Texel& texel : texels) {
      EXPECT_EQ(texel.colour, Vec3d(chain.level(texel.level).at(texel.x, texel.y)));
      sum += texel.colour * texel.weight;
      weights += texel.weight;
    }
    EXPECT_NEAR(weights, 1, 1e-6);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], static_cast<double>(sample.colour[c]), 1e-6);
  }
}

TYPED_TEST(TextureSampling, TrilinearMixesTheLevels) {
  using V = Vec2<TypeParam>;
  const auto chain = noise_chain(16, 16, 5);
  const V uv(TypeParam(0.3), TypeParam(0.8));
  const auto at = [&](double level) {
    return ps::sample_trilinear(chain, uv, TextureWrap::repeat, static_cast<TypeParam>(level));
  };
  for (int level = 0; level < chain.levels(); ++level) {
    EXPECT_EQ(at(level).colour, ps::sample_bilinear(chain.level(level), uv, TextureWrap::repeat));
    EXPECT_EQ(at(level).texels, 4);
    EXPECT_EQ(at(level).level, static_cast<TypeParam>(level));
  }
  const auto quarter = at(1.25);
  EXPECT_EQ(quarter.texels, 8);
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(static_cast<double>(quarter.colour[c]), 0.75 * at(1).colour[c] + 0.25 * at(2).colour[c], 1e-6);
  EXPECT_EQ(at(-2).colour, at(0).colour);
  EXPECT_EQ(at(99).colour, at(4).colour);
  EXPECT_EQ(at(99).level, TypeParam(4));

  const auto mip = [&](double level) {
    return ps::sample_texture<TypeParam>(chain, uv,
                                         {TextureFilter::mipmap, TextureWrap::repeat, static_cast<TypeParam>(level)});
  };
  EXPECT_EQ(mip(1.49).colour, at(1).colour);
  EXPECT_EQ(mip(1.5).colour, at(2).colour);
  EXPECT_EQ(mip(1.5).level, TypeParam(2));
  EXPECT_EQ(mip(1.5).texels, 4);
}

TYPED_TEST(TextureSampling, FloorIsTheCLibrarys) {
  using Limits = std::numeric_limits<TypeParam>;
  for (const double value :
       {0.0, 0.5, -0.5, 1.0, -1.0, 2.999, -2.999, 1073741823.5, 1073741824.0, -1073741824.5, 1e30, -1e30}) {
    const auto real = static_cast<TypeParam>(value);
    EXPECT_EQ(ps::floor_of(real), std::floor(real)) << value;
    EXPECT_EQ(ps::floor_of(std::nextafter(real, Limits::lowest())), std::floor(std::nextafter(real, Limits::lowest())));
  }
  EXPECT_EQ(ps::floor_of(-Limits::infinity()), -Limits::infinity());
  EXPECT_TRUE(std::isnan(ps::floor_of(Limits::quiet_NaN())));
}

TYPED_TEST(TextureSampling, LevelFollowsTheLongerStep) {
  using D = ps::TextureDerivatives<TypeParam>;
  EXPECT_EQ(ps::mip_level(D{{1, 0}, {0, 1}}), TypeParam(0));
  EXPECT_EQ(ps::mip_level(D{{2, 0}, {0, 1}}), TypeParam(1));
  EXPECT_EQ(ps::mip_level(D{{0, 1}, {0, 8}}), TypeParam(3));
  EXPECT_EQ(ps::mip_level(D{{0.25, 0}, {0, 0.125}}), TypeParam(-2));
  EXPECT_EQ(ps::mip_level(D{{0, 1}, {0, 8}}, TypeParam(-0.5)), TypeParam(2.5));
  EXPECT_NEAR(static_cast<double>(ps::mip_level(D{{3, 4}, {1, 1}})), std::log2(5.0), 1e-6);
  EXPECT_LT(ps::mip_level(D{}), TypeParam(-50));  // nothing moves
}

TYPED_TEST(TextureSampling, LevelLogarithmMatchesTheCLibrary) {
  const double bound = sizeof(TypeParam) == 4 ? 1e-6 : 1e-9;
  for (int i = -4000; i <= 4000; ++i) {
    const auto value = static_cast<TypeParam>(std::exp(i * 0.01));
    const double expected = std::log2(static_cast<double>(value));
    EXPECT_NEAR(static_cast<double>(ps::level_log2(value)), expected, bound * std::max(1.0, std::abs(expected)));
  }
}

}  // namespace
}  // namespace texture_sampling_test
