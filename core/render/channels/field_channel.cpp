#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/number_text.h"
#include "record/field_query.h"
#include "render/channels/channels.h"

/// A number of the story, for every pixel.

namespace ps::channels {
namespace {

constexpr Rgb8 marked{240, 228, 66};

std::optional<double> number_at(const Frame& frame, int x, int y) {
  if (const float value = frame.field.at(x, y); std::isfinite(value)) return value;
  return {};
}

/// Titled by its number. Where a condition is asked for, the pixels that meet it stand out from the dimmed others.
void finish(const Frame& frame, ChannelPicture& picture) {
  if (!frame.shown_field) return;
  picture.legend.title = field_query_words(frame.shown_field->query);
  const auto& condition = frame.shown_field->condition;
  if (!condition) return;
  std::size_t met = 0;
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x) {
      Rgb8& level = picture.levels.at(x, y);
      const bool is_met = condition->met_by(frame.field.at(x, y));
      met += is_met ? 1 : 0;
      level = is_met ? marked : dimmed(level);
    }
  picture.legend.entries.push_back(
      {marked, fmt::format("{}: {} pixels", field_condition_text(*condition), with_thousands(std::to_string(met)))});
}

}  // namespace

const ShownChannelRow field_channel{.channel = ShownChannel::field,
                                    .key = "field",
                                    .label = "Number of the story",
                                    .help = "A number of the pixel's story, for every pixel: click one in the story.",
                                    .needs = Channel::field,
                                    .unit = "",
                                    .text =
                                        [](const Frame& frame, const Settings&, Vec2i pixel) {
                                          const auto value = number_at(frame, pixel.x, pixel.y);
                                          return value ? fmt::format("{:.5g}", *value) : std::string("none");
                                        },
                                    .heat = {.value = number_at, .from_zero = false, .without_value = "no such number"},
                                    .finish = finish};

}  // namespace ps::channels
