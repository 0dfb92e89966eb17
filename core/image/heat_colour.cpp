#include "image/heat_colour.h"

#include <array>
#include <cmath>

namespace ps {
namespace {

/// Ten evenly spaced colours of cividis.
constexpr std::array<Rgb8, 10> stops{{{0x00, 0x20, 0x4d},
                                      {0x00, 0x33, 0x6f},
                                      {0x39, 0x48, 0x6b},
                                      {0x57, 0x5c, 0x6d},
                                      {0x70, 0x71, 0x73},
                                      {0x8a, 0x87, 0x79},
                                      {0xa6, 0x9d, 0x75},
                                      {0xc4, 0xb5, 0x6c},
                                      {0xe4, 0xcf, 0x5b},
                                      {0xff, 0xea, 0x46}}};

std::uint8_t mix(std::uint8_t a, std::uint8_t b, double f) {
  return static_cast<std::uint8_t>(std::lround(a + (b - a) * f));
}

}  // namespace

Rgb8 heat_colour(double t) {
  const double clamped = t > 0 ? (t < 1 ? t : 1) : 0;
  const double place = clamped * (stops.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const double f = place - static_cast<double>(i);
  const Rgb8 a = stops[i];
  const Rgb8 b = stops[i + 1];
  return {mix(a.r, b.r, f), mix(a.g, b.g, f), mix(a.b, b.b, f)};
}

Rgb8 id_colour(std::uint32_t id) {
  // Steps of the golden ratio around the colour circle never come close to a recent hue; lightness takes turns too.
  const double turns = static_cast<double>(id % 65536) * 0.6180339887498949 + 0.58;
  const double hue = (turns - std::floor(turns)) * 6;
  constexpr std::array<double, 3> brightness{0.95, 0.7, 0.82};
  constexpr std::array<double, 2> saturation{0.75, 0.5};
  const double value = brightness[id % 3];
  const double low = value * (1 - saturation[id / 3 % 2]);
  const auto wave = [&](double offset) {
    const double position = std::fmod(hue + offset, 6);
    const double up = std::min(std::max(std::abs(position - 3) - 1, 0.0), 1.0);
    return static_cast<std::uint8_t>(std::lround(255 * (low + (value - low) * up)));
  };
  return {wave(0), wave(4), wave(2)};
}

}  // namespace ps
