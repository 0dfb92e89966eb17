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

void Actions::add(Action action) {
  PS_ASSERT(!find(action.name), "action names are unique");
  PS_ASSERT((action.kind == ActionKind::hold) == static_cast<bool>(action.run_hold), "hold actions have run_hold");
  for (const Chord& chord : parse_chords(action.keys)) {
    PS_ASSERT(!bound_to(chord), "two actions must not share a key");
    bindings_.push_back({chord, actions_.size()});
  }
  for (const Chord& chord : parse_chords(action.borrowed_keys)) borrowed_.push_back({chord, actions_.size()});
  actions_.push_back(std::move(action));
}

const Action* Actions::find(std::string_view name) const {
  const auto found = std::find_if(actions_.begin(), actions_.end(), [&](const Action& a) { return a.name == name; });
  return found == actions_.end() ? nullptr : &*found;
}

std::vector<Chord> Actions::chords(std::string_view name) const {
  std::vector<Chord> result;
  for (const auto* bindings : {&bindings_, &borrowed_})
    for (const Binding& binding : *bindings)
      if (actions_[binding.action].name == name) result.push_back(binding.chord);
  return result;
}

std::string Actions::key_text(std::string_view name) const {
  const auto all_chords = chords(name);
  return all_chords.empty() ? std::string() : chord_text(all_chords.front());
}

const Action* Actions::bound_to(const Chord& chord) const {
  for (const Binding& binding : bindings_)
    if (binding.chord == chord) return &actions_[binding.action];
  return nullptr;
}

/// The action that a key press goes to.
const Action* Actions::taker_of(const Chord& chord) const {
  for (const Binding& binding : borrowed_)
    if (binding.chord == chord && enabled(actions_[binding.action])) return &actions_[binding.action];
  return bound_to(chord);
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

bool Actions::key_down(const Chord& chord, bool repeat, bool typing) {
  if (typing && left_to_text_field(chord)) return false;
  const Action* action = taker_of(chord);
  if (!action || !enabled(*action)) return false;
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
      held_.emplace_back(chord.key, static_cast<std::size_t>(action - actions_.data()));
      action->run_hold(true);
    }
    break;
  }
  return true;
}

void Actions::key_up(Key key) {
  for (std::size_t i = 0; i < held_.size();) {
    if (held_[i].first != key) {
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
