#include "scene/texture_generator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/check.h"
#include "base/number_text.h"

namespace ps {
namespace {

using TexelFunction = Vec3f (*)(int x, int y, int size);

Vec3f levels(int r, int g, int b) {
  const auto level = [](int value) { return static_cast<float>(std::clamp(value, 0, 255)) / 255.0F; };
  return {level(r), level(g), level(b)};
}

/// A number from 0 to 255 that depends on all arguments but has no visible pattern.
int grain(int a, int b, int c) {
  auto h = static_cast<std::uint32_t>(a) * 374761393U + static_cast<std::uint32_t>(b) * 668265263U +
           static_cast<std::uint32_t>(c) * 2246822519U;
  h = (h ^ (h >> 13)) * 1274126177U;
  return static_cast<int>((h ^ (h >> 16)) & 255U);
}

Vec3f checker(int x, int y, int size) {
  const bool white = (x * 8 / size + y * 8 / size) % 2 == 0;
  return white ? levels(255, 255, 255) : levels(0, 0, 0);
}

Vec3f tiles(int x, int y, int size) {
  const bool second = (x * 10 / size + y * 10 / size) % 2 == 1;
  const int across = x * 600 / size;
  const int down = y * 600 / size;
  return second ? levels(40 + across * 200 / 600, 40 + down * 200 / 600, 80)
                : levels(230, 220 - down / 5, 200 - across / 5);
}

Vec3f bricks(int x, int y, int size) {
  const int row = y * 8 / size;
  const int shifted = x * 64 / size + (row % 2) * 8;
  const int column = shifted / 16 % 4;
  const bool mortar = shifted % 16 == 0 || y * 64 / size % 8 == 0;
  const int rough = grain(x, y, 1) / 12;
  if (mortar) return levels(170 + rough, 165 + rough, 155 + rough);
  const int tone = grain(row, column, 2) / 5;
  return levels(135 + tone + rough, 60 + tone / 2 + rough, 45 + tone / 3 + rough);
}

/// How far the wall of bricks() stands out at a texel, 0 in the mortar and 1 on a brick, with bevelled edges.
double brick_height(int x, int y, int size) {
  const auto around = [size](int i) { return (i % size + size) % size; };
  const double u = (around(x) + 0.5) * 64 / size, v = (around(y) + 0.5) * 64 / size;
  const double shifted = u + (static_cast<int>(v / 8) % 2) * 8;
  const double across = std::fmod(shifted, 16.0), down = std::fmod(v, 8.0);  // mortar lies in [0, 1)
  const auto above_mortar = [](double at, double period) {
    const double from_middle = std::min(std::abs(at - 0.5), period - std::abs(at - 0.5));
    return std::clamp((from_middle - 0.5) / 1.0, 0.0, 1.0);
  };
  return std::min(above_mortar(across, 16), above_mortar(down, 8));
}

/// Those heights in grey.
Vec3f brick_heights(int x, int y, int size) { return Vec3f(static_cast<float>(brick_height(x, y, size))); }

/// The normals of that wall, as a normal map holds them (shade/normal_mapping.h).
Vec3f brick_normals(int x, int y, int size) {
  const double steepness = 0.012 * size;  // texels that a brick stands out
  const double right = (brick_height(x + 1, y, size) - brick_height(x - 1, y, size)) / 2 * steepness;
  const double below = (brick_height(x, y + 1, size) - brick_height(x, y - 1, size)) / 2 * steepness;
  const Vec3d normal = Vec3d{-right, below, 1} / std::sqrt(right * right + below * below + 1);
  return Vec3f(normal * 0.5 + Vec3d(0.5));
}

/// One plank, lit along its edges; `along` runs with the grain and both coordinates are in 512ths of the picture.
Vec3f plank(int along, int across, int width, int number) {
  const int inside = across % width;
  const int streak = grain(across / 2, along / 48, number) / 9 + grain(across / 5, 0, number) / 7;
  const int tone = grain(number, 0, 3) / 10;
  const int edge = inside < 3 || inside >= width - 3 ? -55 : (inside < 6 ? 18 : 0);
  const int light = streak + tone + edge;
  return levels(130 + light, 88 + light * 4 / 5, 42 + light / 2);
}

Vec3f crate(int x, int y, int size) {
  constexpr int frame = 64;
  const int u = x * 512 / size;
  const int v = y * 512 / size;
  const auto nail = [](int a, int b) {
    const std::array<int, 2> places{frame / 2, 511 - frame / 2};
    return std::any_of(places.begin(), places.end(), [&](int p) {
      return std::any_of(places.begin(), places.end(),
                         [&](int q) { return (a - p) * (a - p) + (b - q) * (b - q) < 70; });
    });
  };
  if (nail(u, v)) return levels(70, 70, 76);
  if (v < frame || v >= 512 - frame) return plank(u, v < frame ? v : v - (512 - frame), frame, v < frame ? 11 : 12);
  if (u < frame || u >= 512 - frame) return plank(v, u < frame ? u : u - (512 - frame), frame, u < frame ? 13 : 14);
  // The panel behind lies in the shadow of the frame; a brace crosses it.
  if (std::abs(u - (511 - v)) < frame / 2) return plank(u - v + 1024, u - (511 - v) + frame / 2, frame, 15);
  const bool shade = u < frame + 10 || v < frame + 10 || std::abs(u - (511 - v)) < frame / 2 + 8;
  return plank(v, u - frame, 48, (u - frame) / 48) * (shade ? 0.55F : 0.82F);
}

/// 1 in the top row, falling by equal steps towards the bottom, where it is 0.
float fall(int y, int size) { return static_cast<float>(size - 1 - y) / static_cast<float>(std::max(size - 1, 1)); }

/// CGPP figure 15.2: single texels of a gradient in a checkerboard with a blue of a hundredth of its largest value. A
/// picture that is stretched or cut shows stripes; without gamma correction the blue looks black.
Vec3f gamma_checker(int x, int y, int size) {
  return (x + y) % 2 == 0 ? Vec3f(fall(y, size)) : Vec3f(0.0F, 0.0F, 0.01F);
}

/// CGPP inline exercise 15.3, right: a gradient of equal steps in radiance.
Vec3f gamma_radiance(int, int y, int size) { return Vec3f(fall(y, size)); }

/// The same, left: a gradient of equal steps in display levels under a gamma of 2.
Vec3f gamma_brightness(int, int y, int size) { return Vec3f(fall(y, size) * fall(y, size)); }

/// The place of a texel in Bayer's 8 x 8 order of thresholds, 0 to 63: the bits of x xor y and of y, mirrored.
int bayer(int x, int y) {
  int order = 0;
  for (int bit = 0; bit < 3; ++bit) order = order << 2 | (((x ^ y) >> bit & 1) << 1) | (y >> bit & 1);
  return order;
}

/// Four strips: a gradient of equal steps in radiance, and beside it the same made of black and white texels alone, as
/// many white ones of 64 as its radiance asks for. They look alike where the display undoes the gamma.
Vec3f gamma_dither(int x, int y, int size) {
  if (x * 4 / size % 2 == 0) return Vec3f(fall(y, size));
  return Vec3f(fall(y, size) * 64.0F > static_cast<float>(bayer(x, y)) + 0.5F ? 1.0F : 0.0F);
}

struct Generator {
  std::string_view name;
  TexelFunction texel;
};
constexpr std::array<Generator, 10> generators{{{"checker", checker},
                                                {"tiles", tiles},
                                                {"bricks", bricks},
                                                {"brick-normals", brick_normals},
                                                {"brick-heights", brick_heights},
                                                {"crate", crate},
                                                {"gamma-checker", gamma_checker},
                                                {"gamma-radiance", gamma_radiance},
                                                {"gamma-brightness", gamma_brightness},
                                                {"gamma-dither", gamma_dither}}};

}  // namespace

std::vector<std::string_view> texture_generators() {
  std::vector<std::string_view> names;
  names.reserve(generators.size());
  for (const Generator& generator : generators) names.push_back(generator.name);
  return names;
}

Image<Vec3f> generate_texture(std::string_view generator, int size) {
  PS_ASSERT(size >= 1 && size <= 4096, "texture sizes are checked where they are read");
  const auto found =
      std::find_if(generators.begin(), generators.end(), [&](const Generator& g) { return g.name == generator; });
  if (found == generators.end())
    throw InputError(fmt::format("unknown texture generator '{}', expected one of {}", generator,
                                 fmt::join(texture_generators(), " ")));
  Image<Vec3f> image(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) image.at(x, y) = found->texel(x, y, size);
  return image;
}

constexpr std::string_view heights_word = "heights ";

std::string heights_generator(double steepness) { return fmt::format("{}{}", heights_word, steepness); }

std::optional<double> heights_steepness(std::string_view generator) {
  if (!generator.starts_with(heights_word)) return {};
  return parse_number(generator.substr(heights_word.size()));
}

}  // namespace ps
