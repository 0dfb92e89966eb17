#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "render/channels/channels.h"

/// Channels of one number for each pixel, shown along heat_colour().

namespace ps::channels {
namespace {

/// A light's map may reach far beyond the objects that cast shadows: colours end at a few times the usual depth.
ValueRange usual_map_depths(const Frame& frame, ValueRange range) {
  constexpr double most = 3;
  std::vector<float> depths;
  for (const float value : frame.shadow_map.pixels())
    if (value >= 0 && std::isfinite(value)) depths.push_back(value);
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  range.high = std::min(range.high, most * *middle);
  return range;
}

std::optional<double> blocked_lights(const Frame& frame, int x, int y) {
  if (frame.ids.at(x, y).object < 0) return {};
  return std::popcount(frame.shadow.at(x, y));
}

std::string blocked_text(const Frame& frame, const Settings&, Vec2i pixel) {
  if (!blocked_lights(frame, pixel.x, pixel.y)) return "nothing";
  std::string text;
  for (unsigned bits = frame.shadow.at(pixel.x, pixel.y); bits != 0; bits &= bits - 1)
    text += fmt::format("{}{}", text.empty() ? "blocked: light " : ", ", std::countr_zero(bits));
  return text.empty() ? "lit" : text;
}

}  // namespace

const ShownChannelRow depth_channel{.channel = ShownChannel::depth,
                                    .key = "depth",
                                    .label = "Depth",
                                    .help = "Distance in front of the camera along its forward axis.",
                                    .needs = Channel::depth,
                                    .unit = "world units",
                                    .text =
                                        [](const Frame& frame, const Settings&, Vec2i pixel) {
                                          const float z = frame.depth.at(pixel.x, pixel.y);
                                          return std::isfinite(z) ? fmt::format("z {:.5g}", z) : "nothing";
                                        },
                                    .heat = {.value = [](const Frame& frame, int x, int y) -> std::optional<double> {
                                               if (const float z = frame.depth.at(x, y); std::isfinite(z)) return z;
                                               return {};
                                             },
                                             .from_zero = false,
                                             .without_value = "nothing seen"},
                                    .floats = [](const Frame& frame) -> ChannelFloats { return frame.depth; }};

const ShownChannelRow overdraw_channel{
    .channel = ShownChannel::overdraw,
    .key = "overdraw",
    .label = "Overdraw",
    .help = "Number of fragments that covered the pixel.",
    .needs = Channel::overdraw,
    .unit = "fragments",
    .text = [](const Frame& frame, const Settings&,
               Vec2i pixel) { return fmt::format("{}", frame.overdraw.at(pixel.x, pixel.y)); },
    .heat = {.value = [](const Frame& frame, int x, int y) -> std::optional<double> { return frame.overdraw.at(x, y); },
             .whole = true}};

const ShownChannelRow tests_channel{
    .channel = ShownChannel::tests,
    .key = "tests",
    .label = "Tests",
    .help = "Number of primitives or samples that were tested for the pixel.",
    .needs = Channel::tests,
    .unit = "tests",
    .text = [](const Frame& frame, const Settings&,
               Vec2i pixel) { return fmt::format("{}", frame.tests.at(pixel.x, pixel.y)); },
    .heat = {.value = [](const Frame& frame, int x, int y) -> std::optional<double> { return frame.tests.at(x, y); },
             .whole = true}};

const ShownChannelRow mip_channel{.channel = ShownChannel::mip,
                                  .key = "mip",
                                  .label = "Mip level",
                                  .help = "Mip level at which the texture was read.",
                                  .needs = Channel::mip,
                                  .unit = "level",
                                  .text =
                                      [](const Frame& frame, const Settings&, Vec2i pixel) {
                                        const double level = frame.mip.at(pixel.x, pixel.y);
                                        return level >= 0 ? fmt::format("level {:.4g}", level) : "no texture";
                                      },
                                  .heat = {.value = [](const Frame& frame, int x, int y) -> std::optional<double> {
                                             if (const float level = frame.mip.at(x, y); level >= 0) return level;
                                             return {};
                                           },
                                           .without_value = "no texture read"}};

const ShownChannelRow samples_channel{
    .channel = ShownChannel::samples,
    .key = "samples",
    .label = "Samples",
    .help = "Number of samples that were averaged for the pixel.",
    .needs = Channel::samples,
    .unit = "samples",
    .text = [](const Frame& frame, const Settings&,
               Vec2i pixel) { return fmt::format("{}", frame.samples.at(pixel.x, pixel.y)); },
    .heat = {.value = [](const Frame& frame, int x, int y) -> std::optional<double> { return frame.samples.at(x, y); },
             .whole = true}};

const ShownChannelRow shadow_channel{.channel = ShownChannel::shadow,
                                     .key = "shadow",
                                     .label = "Shadows",
                                     .help = "Number of lights that are blocked at the point.",
                                     .needs = Channel::shadow | Channel::ids,
                                     .unit = "lights",
                                     .text = blocked_text,
                                     .heat = {.value = blocked_lights, .whole = true, .without_value = "nothing seen"}};

const ShownChannelRow shadow_map_channel{
    .channel = ShownChannel::shadow_map,
    .key = "shadow-map",
    .label = "Shadow maps",
    .help =
        "The shadow maps of the lights, side by side: distance from the light to the nearest surface in each texel.",
    .needs = Channel::shadow_map,
    .unit = "world units",
    .text =
        [](const Frame& frame, const Settings&, Vec2i pixel) {
          const float stored = frame.shadow_map.at(pixel.x, pixel.y);
          if (stored >= 0 && std::isfinite(stored)) return fmt::format("depth {:.5g}", static_cast<double>(stored));
          return std::string(stored < 0 ? "no map here" : "sees nothing");
        },
    .heat = {.value = [](const Frame& frame, int x, int y) -> std::optional<double> {
               if (const float stored = frame.shadow_map.at(x, y); stored >= 0 && std::isfinite(stored)) return stored;
               return {};
             },
             .from_zero = false,
             .without_value = "no surface, or no map",
             .usual = usual_map_depths}};

const ShownChannelRow stencil_channel{
    .channel = ShownChannel::stencil,
    .key = "stencil",
    .label = "Stencil",
    .help = "Counters of the stencil buffers, summed over the lights; 0 = lit.",
    .needs = Channel::stencil,
    .unit = "volumes",
    .text = [](const Frame& frame, const Settings&,
               Vec2i pixel) { return fmt::format("{}", frame.stencil.at(pixel.x, pixel.y)); },
    .heat = {
        .value = [](const Frame& frame, int x, int y) -> std::optional<double> { return frame.stencil.at(x, y); }}};

}  // namespace ps::channels
