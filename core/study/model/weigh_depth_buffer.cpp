#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "options/renderer_kind.h"
#include "study/model/model_search.h"

namespace ps::model {
namespace {

constexpr int most_bits = 24;  ///< of an integer depth buffer

/// Two digits, which is enough for the ends of a range with some room.
double two_digits(double value, double (*round)(double)) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return round(value / unit) * unit;
}

/// The settings with a depth buffer of integers that covers what is visible and little more.
Settings integer_depth(Settings settings, const Evidence& evidence, double plane_distance) {
  constexpr double room = 0.05;
  settings.near = std::max(settings.near, two_digits((1 - room) * evidence.nearest / plane_distance, std::floor));
  settings.far = std::min(settings.far, two_digits((1 + room) * evidence.farthest / plane_distance, std::ceil));
  settings.depth_format = DepthFormat::unorm;
  settings.depth_bits = most_bits;
  return settings;
}

}  // namespace

// Two surfaces at depth z need a gap of about z^2 / (near 2^bits): the channel of gaps has them in units of the buffer.
void ModelSearch::weigh_depth_buffer() {
  if (settings().visibility != Visibility::depth_buffer || !(evidence_.farthest > evidence_.nearest) ||
      !(evidence_.nearest > 0))
    return;
  const double plane_distance = request_.views.front().camera.projection_plane_d;
  Settings integers = integer_depth(settings(), evidence_, plane_distance);
  const double gap = held_.smallest_depth_gap(scene(), integers);
  const int needed = std::isinf(gap) ? 0 : most_bits - static_cast<int>(std::floor(std::log2(std::max(gap, 1.0))));
  const bool has_integers = settings().depth_format == DepthFormat::unorm;
  for (const int bits : {8, 16, most_bits}) {
    if (bits < needed || (has_integers && bits >= settings().depth_bits)) continue;
    integers.depth_bits = bits;
    if (!holds(scene(), integers, Worth::uncounted)) continue;
    if (has_integers) {
      ModelSaving saving{.part = ModelPart::depth_buffer,
                         .goes = part_of_all(static_cast<std::size_t>(settings().depth_bits - bits),
                                             static_cast<std::size_t>(settings().depth_bits), "bit of depth",
                                             "bits of depth")};
      saving.things.push_back({.name = fmt::format("depth bits: {} do for {}, with near = {:g} and far = {:g}", bits,
                                                   settings().depth_bits, integers.near, integers.far)});
      return take(std::move(saving));
    }
    const std::string smallest =
        std::isinf(gap) ? "no surface hides another" : fmt::format("the smallest visible gap needs {} bits", needed);
    needs_.remarks.push_back(
        fmt::format("A rasterizer's depth buffer does with {} bits, near = {:g} and far = {:g}: {}.", bits,
                    integers.near, integers.far, smallest));
    return;
  }
}

}  // namespace ps::model
