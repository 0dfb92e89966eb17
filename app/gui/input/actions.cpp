#include "gui/input/actions.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "base/check.h"

namespace ps::gui {
namespace {

/// A text field needs the key for itself: all without Ctrl or Alt but the function keys and Esc, and the field's own
/// editing commands.
bool left_to_text_field(const Chord& chord) {
  if (chord.key >= Key::f1 && chord.key <= Key::f12) return false;
  if (!chord.ctrl && !chord.alt) return true;
  constexpr Key editing[] = {Key::a, Key::c,    Key::v,     Key::x,         Key::y,
                             Key::z, Key::left, Key::right, Key::backspace, Key::del};
  return std::find(std::begin(editing), std::end(editing), chord.key) != std::end(editing);
}

std::vector<Chord> parse_chords(std::string_view text) {
  std::istringstream words{std::string(text)};
  std::vector<Chord> chords;
  for (std::string word; words >> word;) chords.push_back(parse_chord(word));
  return chords;
}

}  // namespace

Action& Actions::add(Action action) {
  PS_ASSERT(!find(action.name), "action names are unique");
  PS_ASSERT((action.kind == ActionKind::hold) == static_cast<bool>(action.run_hold), "hold actions have run_hold");
  for (const Chord& chord : parse_chords(action.keys)) {
    PS_ASSERT(!bound_to(chord), "two actions must not share a key");
    bindings_.push_back({chord, actions_.size(), action.by_place});
  }
  for (const Chord& chord : parse_chords(action.borrowed_keys)) borrowed_.push_back({chord, actions_.size()});
  return actions_.emplace_back(std::move(action));
}

const Action* Actions::find(std::string_view name) const {
  const auto found = std::find_if(actions_.begin(), actions_.end(), [&](const Action& a) { return a.name == name; });
  return found == actions_.end() ? nullptr : &*found;
}

/// Whether what a key types is bound, so that its place is not asked.
bool Actions::typed_key_is_bound(const KeyMeanings& key) const {
  return std::any_of(bindings_.begin(), bindings_.end(),
                     [&](const Binding& each) { return !each.by_place && each.chord == key.first(); });
}

std::string Actions::label_of(const Binding& binding) const {
  const Chord& chord = binding.chord;
  const KeyboardLayout& layout = keyboard_layout();
  if (!binding.by_place || typed_key_is_bound(layout.meanings({chord.key, chord.ctrl, chord.shift, chord.alt})))
    return layout.label(chord);
  return chord_modifiers(chord) + layout.label_of_place(chord.key);
}

std::vector<std::string> Actions::key_texts(std::string_view name) const {
  std::vector<std::string> result;
  for (const auto* bindings : {&bindings_, &borrowed_})
    for (const Binding& binding : *bindings)
      if (actions_[binding.action].name == name) result.push_back(label_of(binding));
  return result;
}

std::string Actions::key_text(std::string_view name) const {
  const auto texts = key_texts(name);
  return texts.empty() ? std::string() : texts.front();
}

const Action* Actions::bound_to(const Chord& chord) const {
  for (const Binding& binding : bindings_)
    if (binding.chord == chord) return &actions_[binding.action];
  return nullptr;
}

/// The enabled action that a key press goes to.
const Action* Actions::taker_of(const KeyMeanings& key) const {
  const auto among = [&](const std::vector<Binding>& bindings, const Chord& chord, bool by_place) -> const Action* {
    for (const Binding& binding : bindings)
      if (binding.chord == chord && binding.by_place == by_place && enabled(actions_[binding.action]))
        return &actions_[binding.action];
    return nullptr;
  };
  for (const auto* bindings : {&borrowed_, &bindings_})
    for (const Chord& chord : key.chords)
      if (const Action* found = among(*bindings, chord, false)) return found;
  if (!typed_key_is_bound(key))
    if (const Action* found = among(bindings_, key.at_place, true)) return found;
  for (const Chord& chord : key.chords)
    if (const Action* found = among(bindings_, chord, true)) return found;
  return nullptr;
}

std::vector<Actions::Meaning> Actions::meanings() const {
  std::vector<Meaning> all;
  const auto find = [&](const Chord& chord) {
    return std::find_if(all.begin(), all.end(), [&](const Meaning& each) { return each.chord == chord; });
  };
  // A borrowed key is not its owner's while the borrower is enabled.
  for (const auto* bindings : {&borrowed_, &bindings_}) {
    const std::size_t known = all.size();
    for (const Binding& binding : *bindings) {
      if (!enabled(actions_[binding.action])) continue;
      const auto found = find(binding.chord);
      if (found == all.end())
        all.push_back({binding.chord, {actions_[binding.action].name}});
      else if (static_cast<std::size_t>(found - all.begin()) >= known)
        found->actions.push_back(actions_[binding.action].name);
    }
  }
  return all;
}

bool Actions::run(std::string_view name) const {
  const Action* action = find(name);
  if (!action || !action->run || !enabled(*action)) return false;
  action->run();
  return true;
}

void Actions::rebind(const std::string& text, const std::string& file) {
  std::vector<Binding> bindings = bindings_;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line.resize(std::min(line.size(), line.find('#')));
    const auto equals = line.find('=');
    std::istringstream words(line.substr(0, equals));
    std::string name, excess;
    if (!(words >> name)) {
      if (equals == std::string::npos) continue;
      throw InputError({file, number, 1}, "no name before '='", "action = keys");
    }
    if (equals == std::string::npos || words >> excess)
      throw InputError({file, number, 1}, "'" + line + "'", "action = keys");
    const Action* action = find(name);
    if (!action) throw InputError({file, number, 1}, "'" + name + "'", "the name of an action (see the help sheet)");
    const auto index = static_cast<std::size_t>(action - actions_.data());
    std::erase_if(bindings, [&](const Binding& b) { return b.action == index; });
    try {
      for (const Chord& chord : parse_chords(std::string_view(line).substr(equals + 1))) {
        std::erase_if(bindings, [&](const Binding& b) { return b.chord == chord; });  // the file's wish comes first
        bindings.push_back({chord, index});
      }
    } catch (const InputError& error) {
      throw InputError({file, number, static_cast<int>(equals) + 2}, error.what(), "keys separated by spaces");
    }
  }
  bindings_ = std::move(bindings);
}

bool Actions::key_down(const KeyMeanings& key, bool repeat, bool typing) {
  if (typing && left_to_text_field(key.first())) return false;
  const Action* action = taker_of(key);
  if (!action) return false;
  last_by_key_ = action->name;
  switch (action->kind) {
  case ActionKind::press:
    if (!repeat) action->run();
    break;
  case ActionKind::repeat:
    action->run();
    break;
  case ActionKind::hold:
    if (!repeat) {
      held_.emplace_back(key.at_place.key, static_cast<std::size_t>(action - actions_.data()));
      action->run_hold(true);
    }
    break;
  }
  return true;
}

void Actions::key_up(Key place) {
  for (std::size_t i = 0; i < held_.size();) {
    if (held_[i].first != place) {
      ++i;
      continue;
    }
    const std::size_t action = held_[i].second;
    held_.erase(held_.begin() + static_cast<std::ptrdiff_t>(i));
    actions_[action].run_hold(false);
  }
}

void Actions::release_all() {
  const auto held = std::exchange(held_, {});
  for (const auto& [key, action] : held) actions_[action].run_hold(false);
}

}  // namespace ps::gui
