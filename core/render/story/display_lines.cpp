#include "render/story/display_lines.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "record/value_text.h"

namespace ps {
namespace {

constexpr std::array<std::string_view, 3> channel_names{"red", "green", "blue"};
constexpr std::array clamps{LedgerTerm::clamped_red, LedgerTerm::clamped_green, LedgerTerm::clamped_blue};

std::string_view depth_text(ColourDepth depth) {
  switch (depth) {
  case ColourDepth::bits24:
    return "8 bits for each colour";
  case ColourDepth::bits16:
    return "5 bits for red and blue, 6 for green";
  case ColourDepth::bits15:
    return "5 bits for each colour";
  }
  return "";
}

std::string clamp_text(std::string_view channel, double value) {
  if (std::isnan(value)) return fmt::format("{} is not a number: 0 is stored", channel);
  return fmt::format("{} {} is clamped to {}", channel, number_text(value), value > 1 ? 1 : 0);
}

}  // namespace

std::vector<LedgerLine> display_lines(const PixelStory& story, const Settings& settings) {
  const int event = story.events.empty() ? -1 : static_cast<int>(story.events.size()) - 1;
  std::vector<LedgerLine> lines;
  const auto add = [&](LedgerTerm kind, std::string text) {
    lines.push_back({0, kind, std::move(text), Vec3d{0, 0, 0}, event});
  };
  if (settings.exposure != 1)
    add(LedgerTerm::exposure, fmt::format("multiplied by exposure {}", number_text(settings.exposure)));
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double value = story.linear[static_cast<int>(channel)] * settings.exposure;
    if (!(value >= 0 && value <= 1)) add(clamps.at(channel), clamp_text(channel_names.at(channel), value));
  }
  if (settings.gamma != 1)
    add(LedgerTerm::gamma, fmt::format("to the power 1 / {} (gamma)", number_text(settings.gamma)));
  add(LedgerTerm::stored, fmt::format("stored as {}, {}, {} of 255 ({})", story.display[0], story.display[1],
                                      story.display[2], depth_text(settings.colour_depth)));
  return lines;
}

}  // namespace ps
