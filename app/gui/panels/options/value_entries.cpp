#include "gui/panels/options/value_entries.h"

#include <fmt/format.h>

#include <array>

#include "options/option.h"
#include "render/channel_picture.h"

namespace ps::gui {
namespace {

struct Value {
  OptionNumber number = 0;
  std::string_view key, label;
};

std::vector<Value> values_of(const Option& option) {
  if (option.kind == OptionKind::boolean) return {{1, "on", "on"}, {0, "off", "off"}};
  std::vector<Value> all;
  for (const Choice& choice : option.choices)
    all.push_back({static_cast<OptionNumber>(all.size()), choice.key, choice.label});
  return all;
}

enum class Effect { has_it, none, sets_it };

Effect effect_of(const Session& session, const Option& option, Side side, const Value& value) {
  if (option.get(session.settings(side)) == value.number) return Effect::has_it;
  if (inactive_reason(option, session.settings(side), session.traits())) return Effect::none;
  return Effect::sets_it;
}

/// The effect of Enter, in few words.
std::string in_words(Effect effect, Side side) {
  const char letter = letter_of(side);
  switch (effect) {
  case Effect::has_it:
    return fmt::format("{} has it", letter);
  case Effect::none:
    return fmt::format("no effect in {}", letter);
  case Effect::sets_it:
    return fmt::format("set in {}", letter);
  }
  return {};
}

std::array<Side, 2> picked_first(const Session& session) {
  return {session.document().picked, other_side(session.document().picked)};
}

}  // namespace

std::vector<PaletteEntry> value_entries(Session& session) {
  std::vector<PaletteEntry> entries;
  for (const Option& option : option_table())
    for (const Value& value : values_of(option)) {
      PaletteEntry& entry = entries.emplace_back();
      entry.name = fmt::format("value/{}/{}", option.key, value.key);
      entry.label = fmt::format("{}: {}", option.label, value.label);
      entry.words = fmt::format("{}, {} {}, {}", value.key, option.key, value.key, value.label);
      for (const Side side : picked_first(session)) {
        const auto set = [&session, &option, side, number = value.number] {
          Settings settings = session.settings(side);
          option.set(settings, number);
          session.set_settings(side, settings,
                               fmt::format("{}: {} = {}", letter_of(side), option.key, option_text(option, settings)));
        };
        const Effect effect = effect_of(session, option, side, value);
        entry.pictures.push_back({letter_of(side), in_words(effect, side), effect == Effect::sets_it, set});
      }
    }
  return entries;
}

std::vector<PaletteEntry> channel_entries(Session& session) {
  std::vector<PaletteEntry> entries;
  for (const ShownChannelRow& row : shown_channels()) {
    PaletteEntry& entry = entries.emplace_back();
    entry.name = fmt::format("channel/{}", row.key);
    entry.label = fmt::format("Show: {}", row.label);
    entry.words =
        fmt::format("{}, {}s, {}, channel{}", row.key, row.key, row.label, row.heat.value ? ", heatmap, heat map" : "");
    for (const Side side : picked_first(session)) {
      const auto show = [&session, side, channel = row.channel] {
        session.edit("show another channel", "channel",
                     [&](Document& document) { side_of(document, side).show = channel; });
      };
      const bool shown = session.shown(side) == row.channel;
      entry.pictures.push_back(
          {letter_of(side), in_words(shown ? Effect::has_it : Effect::sets_it, side), !shown, show});
    }
  }
  return entries;
}

}  // namespace ps::gui
