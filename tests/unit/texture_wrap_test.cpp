// Wrap modes against pictures that spell out what they stand for: three by three copies of a texture, read in the
// middle.
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "image/texture_sampling.h"

namespace ps::texture_wrap_test {
namespace {

constexpr int size = 16;

Image<Vec3f> noise(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value(0, 1);
  Image<Vec3f> image(size, size);
  for (Vec3f& texel : image.pixels()) texel = Vec3f(value(random), value(random), value(random));
  return image;
}

/// The texture with a copy on each side, as `wrap` says.
Image<Vec3f> spelled_out(const Image<Vec3f>& image, TextureWrap wrap) {
  const auto inside = [&](int i) {
    const int tile = i / size, within = i % size;
    if (wrap == TextureWrap::repeat) return within;
    if (wrap == TextureWrap::mirror) return tile % 2 == 1 ? within : size - 1 - within;
    return tile == 0 ? 0 : tile == 1 ? within : size - 1;
  };
  Image<Vec3f> copies(3 * size, 3 * size);
  for (int y = 0; y < 3 * size; ++y)
    for (int x = 0; x < 3 * size; ++x) copies.at(x, y) = image.at(inside(x), inside(y));
  return copies;
}

/// Largest difference between the wrapped texture and the copies, at the levels up to `coarsest`.
double difference(const MipChain& wrapped, const MipChain& copies, TextureWrap wrap, TextureFilter filter, int coarsest,
                  unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-0.45, 1.45), level(0, coarsest);
  double worst = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec2d uv(coordinate(random), coordinate(random));
    const double at = coarsest == 0 ? 0 : level(random);
    const Vec2d among((uv.x + 1) / 3, (uv.y + 1) / 3);
    const Vec3d a = sample_texture<double>(wrapped, uv, {filter, wrap, at}).colour;
    const Vec3d b = sample_texture<double>(copies, among, {filter, TextureWrap::clamp, at}).colour;
    for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(a[c] - b[c]));
  }
  return worst;
}

// Sides of 16 and 48 texels halve alike down to 1 and 3: on these levels the copies are copies still. At the border of
// a level repeat mixes texels of both sides, mirror a texel with itself.
TEST(TextureWrap, IsCopiesOfTheTextureAtEveryLevel) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  const Image<Vec3f> image = noise(seed);
  const auto chain_of = [](const Image<Vec3f>& picture) {
    return make_mip_chain(std::make_shared<const Image<Vec3f>>(picture), MipLevels::all);
  };
  const MipChain plain = chain_of(image);
  for (const TextureFilter filter :
       {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::mipmap, TextureFilter::trilinear})
    for (const TextureWrap wrap : {TextureWrap::repeat, TextureWrap::mirror}) {
      const MipChain copies = chain_of(spelled_out(image, wrap));
      EXPECT_LT(difference(plain, copies, wrap, filter, 4, seed), 1e-6)
          << static_cast<int>(filter) << ", " << static_cast<int>(wrap);
      const TextureWrap wrong = wrap == TextureWrap::repeat ? TextureWrap::mirror : TextureWrap::repeat;
      EXPECT_GT(difference(plain, copies, wrong, filter, 4, seed), 0.01) << "the test must tell them apart";
    }
}

// Clamped, the border goes on for ever; coarser levels have a border of their own, so only the finest is copies.
TEST(TextureWrap, ClampGoesOnWithTheBorder) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  const Image<Vec3f> image = noise(seed);
  const auto finest = [](const Image<Vec3f>& picture) {
    return make_mip_chain(std::make_shared<const Image<Vec3f>>(picture), MipLevels::finest_only);
  };
  const MipChain plain = finest(image), copies = finest(spelled_out(image, TextureWrap::clamp));
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear})
    EXPECT_LT(difference(plain, copies, TextureWrap::clamp, filter, 0, seed), 1e-6);
}

}  // namespace
}  // namespace ps::texture_wrap_test
