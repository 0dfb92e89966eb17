#include "gui/panels/options/value_entries.h"

#include <fmt/format.h>

#include <array>

#include "options/option.h"

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

}  // namespace

std::vector<PaletteEntry> value_entries(Session& session) {
  std::vector<PaletteEntry> entries;  // of the picked picture first
  for (const Option& option : option_table())
    for (const Value& value : values_of(option))
      for (const Side side : {session.document().picked, other_side(session.document().picked)}) {
        const auto set = [&session, &option, side, number = value.number] {
          Settings settings = session.settings(side);
          option.set(settings, number);
          session.set_settings(side, settings,
                               fmt::format("{}: {} = {}", letter_of(side), option.key, option_text(option, settings)));
        };
        const Effect effect = effect_of(session, option, side, value);
        entries.push_back({.name = fmt::format("value/{}/{}/{}", option.key, value.key, side == Side::a ? "a" : "b"),
                           .label = fmt::format("{}: {}", option.label, value.label),
                           .kind = in_words(effect, side),
                           .run = set,
                           .words = fmt::format("{} {}", option.key, value.key),
                           .changes = effect == Effect::sets_it});
      }
  return entries;
}

}  // namespace ps::gui
