#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gui/input/keyboard_layout.h"

namespace ps::gui {

enum class ActionKind {
  press,   ///< runs once for each key press
  repeat,  ///< runs also while the key repeats
  hold     ///< on while the key is down: run_hold(true), later run_hold(false)
};

/// Something that the user can do. Menus, key bindings, the help sheet, the palette and tests are made from the table
/// of actions.
struct Action {
  std::string name;       ///< stable, in kebab-case: "pixel-left"
  std::string label;      ///< for people: "Nudge the pixel left"
  std::string group;      ///< heading in the help sheet: "Pixel"
  std::string keys = {};  ///< default chords separated by spaces: "Enter PageDown"; may be empty
  /// Whether these are where a US keyboard has them, for keys that a hand finds by their places. Not so where a place
  /// types a letter that means something else; and a user's own keys are those that type what was written.
  bool by_place = false;
  /// Chords of other actions that are this one's while it is enabled: a remote control has few keys.
  std::string borrowed_keys = {};
  ActionKind kind = ActionKind::press;
  std::function<void()> run = {};           ///< press and repeat
  std::function<void(bool)> run_hold = {};  ///< hold
  std::function<bool()> enabled = {};       ///< empty = always
  std::function<bool()> checked = {};       ///< for toggles in menus; empty = not a toggle
};

/// Something done with the mouse, for the help sheet.
struct Gesture {
  std::string hand;   ///< "Shift+drag"
  std::string label;  ///< for people: "Render a rectangle alone"
  std::string group;  ///< heading in the help sheet
  /// In place of a hand, keys by place: "WASD".
  std::string places = {};
};

/// A line of the palette besides the actions, found by its label or by other words.
struct PaletteEntry {
  /// What it would do to one of the two pictures.
  struct ForPicture {
    char picture = 'A';
    std::string effect;   ///< in few words: "set in A", "A has it"
    bool changes = true;  ///< false where it has that already, or cannot act
    std::function<void()> run;
  };
  std::string name;  ///< stable: "lesson/cgfs_03_light", "option/shading"
  std::string label;
  std::string kind;  ///< "lesson", "option": written where actions have their keys
  std::function<void()> run = {};
  std::string words = {};  ///< not shown: what else people call it, with commas between
  /// In place of `run`: what it does to each picture; Enter takes the first that changes.
  std::vector<ForPicture> pictures = {};
  std::string leads_to = {};  ///< in place of `run`: the name of an action or another entry
};

class Actions {
 public:
  /// Adds an action; its name must be new and its default chords must be free. Answers it, valid until the next one.
  Action& add(Action action);
  const std::vector<Action>& all() const { return actions_; }
  void add_gesture(Gesture gesture) { gestures_.push_back(std::move(gesture)); }
  const std::vector<Gesture>& gestures() const { return gestures_; }
  /// What the palette offers after the actions; asked for each time that it opens.
  void offer_more(std::function<std::vector<PaletteEntry>()> more) { more_ = std::move(more); }
  std::vector<PaletteEntry> more() const { return more_ ? more_() : std::vector<PaletteEntry>(); }
  const Action* find(std::string_view name) const;
  /// The first chord bound to the action for menus and tooltips, as the keyboard has it; "" if none.
  std::string key_text(std::string_view name) const;
  /// All chords bound to it likewise, the borrowed ones last.
  std::vector<std::string> key_texts(std::string_view name) const;
  const Action* bound_to(const Chord& chord) const;
  /// What each chord does now: the enabled actions that take it, which is one, unless two actions want the same key.
  struct Meaning {
    Chord chord;
    std::vector<std::string> actions;
  };
  std::vector<Meaning> meanings() const;
  /// The action that a key ran last; empty before the first.
  const std::string& last_by_key() const { return last_by_key_; }
  /// Runs the action unless it is disabled; answers whether it ran. Hold actions are not run this way.
  bool run(std::string_view name) const;
  bool enabled(const Action& action) const { return !action.enabled || action.enabled(); }
  /// Reads lines "name = Chord Chord ..." (# starts a comment); these replace the default chords, and mean what is
  /// typed, but for digits. Throws InputError with line and column, leaving the bindings as they were.
  void rebind(const std::string& text, const std::string& file);

  /// For the shell: key went down or up this frame. Answers whether an action took it. Letters without Ctrl are left
  /// to text fields when `typing`.
  bool key_down(const KeyMeanings& key, bool repeat, bool typing);
  void key_up(Key place);
  /// The window lost the keyboard: ends all hold actions.
  void release_all();

 private:
  struct Binding {
    Chord chord;
    std::size_t action;
    bool by_place = false;
  };
  std::vector<Action> actions_;
  std::vector<Gesture> gestures_;
  std::function<std::vector<PaletteEntry>()> more_;
  const Action* taker_of(const KeyMeanings& key) const;
  bool typed_key_is_bound(const KeyMeanings& key) const;
  std::string label_of(const Binding& binding) const;
  std::vector<Binding> bindings_, borrowed_;
  std::string last_by_key_;
  std::vector<std::pair<Key, std::size_t>> held_;  // place of the key, action
};

/// Adds the common actions of one group.
class ActionGroup {
 public:
  /// `enabled`: when they are; empty = always.
  ActionGroup(Actions& actions, std::string group, std::function<bool()> enabled = {})
      : actions_(actions), group_(std::move(group)), enabled_(std::move(enabled)) {}
  Action& add(std::string name, std::string label, std::string keys, std::function<void()> run) {
    return actions_.add({.name = std::move(name),
                         .label = std::move(label),
                         .group = group_,
                         .keys = std::move(keys),
                         .run = std::move(run),
                         .enabled = enabled_});
  }
  /// One that runs also while its key repeats.
  void add_repeated(std::string name, std::string label, std::string keys, std::function<void()> run) {
    add(std::move(name), std::move(label), std::move(keys), std::move(run)).kind = ActionKind::repeat;
  }
  /// One that menus show with a tick while `checked`.
  void add_toggle(std::string name, std::string label, std::string keys, std::function<void()> run,
                  std::function<bool()> checked) {
    add(std::move(name), std::move(label), std::move(keys), std::move(run)).checked = std::move(checked);
  }

 private:
  Actions& actions_;
  std::string group_;
  std::function<bool()> enabled_;
};

}  // namespace ps::gui
