#include "gui/script/player.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <utility>

#include "base/atomic_file.h"
#include "base/sanitizers.h"
#include "gui/base/hand_clock.h"
#include "gui/base/record.h"
#include "gui/base/values.h"
#include "gui/script/expectation.h"
#include "image/file.h"

namespace ps::gui {
namespace {

constexpr double between_commands = 1;  // seconds of the hand's clock
// Work takes some twenty times as long under the thread sanitizer.
constexpr std::chrono::seconds wait_limit{with_thread_sanitizer ? 900 : 120};
/// Frames until ImGui has seen an event and drawn what follows from it.
constexpr int frames_after_input = 2;
/// Frames in which a control may be scrolled to or its section may open.
constexpr int frames_to_reveal = 12;

/// A command failed; ends the script with exit status 1.
class ScriptFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

std::vector<Command> load(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  if (!std::filesystem::is_regular_file(path) || !(text << file.rdbuf()))
    throw InputError({path, 0, 0}, "no readable file", "a script");
  return parse_script(text.str(), path);
}

MouseButton button_named(const std::string& word) {
  return word == "right" ? MouseButton::right : word == "middle" ? MouseButton::middle : MouseButton::left;
}

/// The key that is held during a drag, if the word names one.
Chord held_key(const std::string& word) {
  return {.ctrl = word == "ctrl", .shift = word == "shift", .alt = word == "alt"};
}

}  // namespace

ScriptPlayer::ScriptPlayer(const std::string& path) : commands_(load(path)) {}

void ScriptPlayer::fail(const std::string& message) const {
  const SourcePlace& place = current_->place;
  throw ScriptFailure(fmt::format("{}:{}: {}", place.file, place.line, message));
}

ScriptStep ScriptPlayer::step(Window& window, Content& content, LoopState state) {
  window_ = &window;
  content_ = &content;
  state_ = state;
  if (frames_needed_ > 0 || state.input_pending) return {.frame = true};
  try {
    if (parts_.empty()) {
      if (next_ == commands_.size()) return {.ended = true};
      current_ = &commands_[next_++];
      if (current_->verb == Verb::quit) return {.ended = true};
      hand_clock().pass(between_commands);
      begin(*current_);
    } else if (parts_.front()() == Turn::done) {
      parts_.pop_front();
    }
  } catch (const ScriptFailure& failure) {
    std::cerr << failure.what() << std::endl;
    return {.ended = true, .status = 1};
  } catch (const InputError& error) {
    std::cerr << fmt::format("{}:{}: {}", current_->place.file, current_->place.line, error.what()) << std::endl;
    return {.ended = true, .status = 1};
  }
  return {.frame = frames_needed_ > 0};
}

double ScriptPlayer::patience() const {
  if (wait_until_ > Clock::now()) return std::chrono::duration<double>(wait_until_ - Clock::now()).count();
  return watching_ ? 0.004 : 0;
}

void ScriptPlayer::frame_drawn(const Window& window) {
  if (frames_needed_ > 0) --frames_needed_;
  if (screenshot_.empty() || frames_needed_ > 0) return;
  try {
    save_image(std::exchange(screenshot_, {}), window.screenshot());
  } catch (const InputError& error) {
    part([this, message = std::string(error.what())]() -> Turn { fail(message); });
  }
}

void ScriptPlayer::begin(const Command& command) {
  std::vector<std::string> words;
  for (const std::string& word : command.words) words.push_back(expand(word));
  const unsigned id = window_->id();
  switch (command.verb) {
  case Verb::wait:
    return begin_wait(command);
  case Verb::set:
  case Verb::set_b:
    content_->set_option(command.verb == Verb::set ? Side::a : Side::b, words[0]);
    return after_frames(1);
  case Verb::click_pixel:
  case Verb::click:
    return begin_click(command);
  case Verb::choose:
    return begin_choose(command);
  case Verb::drag:
    return begin_drag(command);
  case Verb::press:
  case Verb::lift:
    push_button(id, button_named(words.empty() ? "left" : words[0]), command.verb == Verb::press, target_.x, target_.y,
                1);
    return after_frames(frames_after_input);
  case Verb::move:
    if (is_number_pair(words[0])) {
      const NumberPair point = parse_number_pair(words[0], command.place);
      return aim_at_point(point.first, point.second);
    }
    return aim_at(words[0]);
  case Verb::wheel:
    push_wheel(id, static_cast<float>(parse_script_number(words[0], command.place, wheel_range)));
    return after_frames(frames_after_input);
  case Verb::type:
    push_text(id, words[0]);
    return after_frames(frames_after_input);
  case Verb::key:
    push_key(id, parse_chord(words[0]), true);
    push_key(id, parse_chord(words[0]), false);
    return after_frames(frames_after_input);
  case Verb::hold:
  case Verb::release:
    push_key(id, parse_chord(words[0]), command.verb == Verb::hold);
    return after_frames(frames_after_input);
  case Verb::open:
    content_->open(words[0]);
    return after_frames(1);
  case Verb::drop:
    push_drop(id, words[0]);
    return after_frames(frames_after_input);
  case Verb::write:
    write_file_atomically(words[0], words[1]);
    return;
  case Verb::clock:
    hand_clock().stand_at(parse_script_number(words[0], command.place, clock_range));
    return;
  case Verb::draw:
    draws_ = words[0] == "on";
    return;
  case Verb::screenshot:
    screenshot_ = words[0];
    return after_frames(1);
  case Verb::expect:
  case Verb::expect_not:
    return check_expectation(command);
  case Verb::keep:
    kept_[command.words[1]] = value_of(command.words[0]);
    return;
  case Verb::print:
    std::cout << value_of(command.words[0]) << std::endl;
    return;
  case Verb::resize: {
    const NumberPair size = parse_number_pair(words[0], command.place, 'x', size_range);
    window_->resize({static_cast<int>(size.first), static_cast<int>(size.second)});
    return after_frames(4);
  }
  case Verb::quit:
    return;
  }
}

void ScriptPlayer::begin_wait(const Command& command) {
  if (command.words[0] == "idle") return wait_for_idle();
  if (command.words[0] == "until") return wait_until(command);
  if (command.words[0] == "frames")
    return after_frames(static_cast<int>(parse_script_number(command.words[1], command.place, frames_range)));
  wait_until_ = Clock::now() + std::chrono::milliseconds(static_cast<std::int64_t>(
                                   parse_script_number(command.words[0], command.place, milliseconds_range)));
  part([this] { return Clock::now() < wait_until_ ? Turn::again : Turn::done; });
}

void ScriptPlayer::wait_for_idle() {
  watching_ = true;
  part([this, limit = Clock::now() + wait_limit] {
    if (!state_.idle && Clock::now() > limit) fail(fmt::format("still busy after {} s", wait_limit.count()));
    watching_ = !state_.idle;
    return state_.idle ? Turn::done : Turn::again;
  });
  // Work that ended after the last frame is not on the screen yet: one frame more, and still nothing to do.
  part([this] {
    after_frames(1);
    return Turn::done;
  });
  part([this] {
    if (!state_.idle) wait_for_idle();
    return Turn::done;
  });
}

void ScriptPlayer::wait_until(const Command& command) {
  Expectation wanted;
  if (command.words.size() == 4) wanted.relation = command.words[2];
  wanted.value = expand(command.words.back());
  watching_ = true;
  part([this, name = command.words[1], wanted, limit = Clock::now() + wait_limit] {
    const std::string found = value_of(name);
    watching_ = !fulfils(found, wanted);
    if (watching_ && Clock::now() > limit)
      fail(fmt::format("{}: still '{}' after {} s, expected {} '{}'", name, found, wait_limit.count(), wanted.relation,
                       wanted.value));
    return watching_ ? Turn::again : Turn::done;
  });
}

void ScriptPlayer::aim_at_point(double x, double y) {
  target_ = {static_cast<float>(x), static_cast<float>(y)};
  push_move(window_->id(), target_.x, target_.y);
  after_frames(frames_after_input);
}

void ScriptPlayer::aim_at(const std::string& name) {
  part([this, name, tries = std::make_shared<int>(0)] {
    const ControlRecord* control = controls().find(name);
    if (control && controls().visible(*control)) {
      controls().stop_revealing();
      if (!control->enabled) fail(fmt::format("control '{}' cannot be used now", name));
      aim_at_point((control->min.x + control->max.x) / 2, (control->min.y + control->max.y) / 2);
      return Turn::done;
    }
    if (++*tries > frames_to_reveal) {
      controls().stop_revealing();
      fail(control ? fmt::format("control '{}' is not on screen and cannot be scrolled into view", name)
                   : fmt::format("there is no control '{}'{}", name, similar_controls(name, Named::control)));
    }
    controls().reveal(name);
    after_frames(2);
    return Turn::again;
  });
  // The controls beside it may have changed meanwhile, and a hand follows the one that it has in sight.
  part([this, name, tries = std::make_shared<int>(0)] {
    const ControlRecord* control = controls().find(name);
    if (!control || !controls().visible(*control) || ++*tries > frames_to_reveal) return Turn::done;
    const auto within = [](float value, float low, float high) { return value >= low && value < high; };
    if (within(target_.x, control->min.x, control->max.x) && within(target_.y, control->min.y, control->max.y))
      return Turn::done;
    aim_at_point((control->min.x + control->max.x) / 2, (control->min.y + control->max.y) / 2);
    return Turn::again;
  });
}

void ScriptPlayer::press(MouseButton button, int clicks) {
  for (const bool down : {true, false})
    part([this, button, clicks, down] {
      if (down) hand_clock().pass(between_commands);  // what it is aimed at may have come into sight just now
      push_button(window_->id(), button, down, target_.x, target_.y, clicks);
      after_frames(down ? 1 : frames_after_input);
      return Turn::done;
    });
}

void ScriptPlayer::begin_click(const Command& command) {
  if (command.verb == Verb::click_pixel) {
    const NumberPair pair = parse_number_pair(command.words[1], command.place, ',', pixel_range);
    const Vec2i pixel(static_cast<int>(pair.first), static_cast<int>(pair.second));
    const auto place = content_->pixel_place(command.words[0] == "A" ? Side::a : Side::b, pixel);
    if (!place) fail("pixel " + command.words[1] + " of " + command.words[0] + " is not on screen");
    // Pointer positions are whole: of those inside a pixel at least one screen pixel wide, the one nearest its middle.
    aim_at_point(std::ceil(place->x - 0.5f), std::ceil(place->y - 0.5f));
    press(MouseButton::left, 1);
    return go_on_to(pixel);
  }
  aim_at(expand(command.words[0]));
  const std::string kind = command.words.size() > 1 ? command.words[1] : "left";
  const auto control_key = [this](bool down) {
    part([this, down] {
      push_key(window_->id(), {.ctrl = true}, down);
      after_frames(1);
      return Turn::done;
    });
  };
  if (kind == "ctrl") control_key(true);
  press(button_named(kind), 1);
  if (kind == "double") press(MouseButton::left, 2);
  if (kind == "ctrl") control_key(false);
}

/// In a picture that is shown smaller than it is, a click may fall on a neighbour that shares the screen's pixel. From
/// there the arrow keys lead to the one that is meant, as a hand would do it.
void ScriptPlayer::go_on_to(Vec2i pixel) {
  part([this, pixel] {
    constexpr int near = 4;  // beyond, the click has had another effect
    const auto picked = values().find("pixel");
    if (!picked || !is_number_pair(*picked)) return Turn::done;
    const NumberPair at = parse_number_pair(*picked, current_->place);
    const int right = pixel.x - static_cast<int>(at.first), down = pixel.y - static_cast<int>(at.second);
    if ((right == 0 && down == 0) || std::abs(right) > near || std::abs(down) > near) return Turn::done;
    const Chord key = parse_chord(right > 0 ? "Right" : right < 0 ? "Left" : down > 0 ? "Down" : "Up");
    push_key(window_->id(), key, true);
    push_key(window_->id(), key, false);
    after_frames(frames_after_input);
    return Turn::again;
  });
}

void ScriptPlayer::begin_choose(const Command& command) {
  const std::string name = expand(command.words[0]), item = name + "/" + expand(command.words[1]);
  aim_at(name);
  part([this, item] {
    if (!controls().find(item)) press(MouseButton::left, 1);  // a drop-down: open its list
    aim_at(item);
    press(MouseButton::left, 1);
    return Turn::done;
  });
}

void ScriptPlayer::begin_drag(const Command& command) {
  const NumberPair second = parse_number_pair(command.words[1], command.place);
  const bool absolute = is_number_pair(command.words[0]);
  if (absolute) {
    const NumberPair first = parse_number_pair(command.words[0], command.place);
    aim_at_point(first.first, first.second);
  } else {
    aim_at(command.words[0]);
  }
  const std::string how = command.words.size() > 2 ? command.words[2] : "left";
  part([this, second, absolute, button = button_named(how), key = held_key(how)] {
    const WindowPoint from = target_;
    const WindowPoint to =
        absolute ? WindowPoint{static_cast<float>(second.first), static_cast<float>(second.second)}
                 : WindowPoint{from.x + static_cast<float>(second.first), from.y + static_cast<float>(second.second)};
    if (key != Chord{}) push_key(window_->id(), key, true);
    push_button(window_->id(), button, true, from.x, from.y, 1);
    constexpr int steps = 8;
    for (int i = 1; i <= steps; ++i)
      part([this, from, to, i] {
        const float share = static_cast<float>(i) / steps;
        aim_at_point(from.x + share * (to.x - from.x), from.y + share * (to.y - from.y));
        return Turn::done;
      });
    part([this, button, key] {
      push_button(window_->id(), button, false, target_.x, target_.y, 1);
      if (key != Chord{}) push_key(window_->id(), key, false);
      after_frames(frames_after_input);
      return Turn::done;
    });
    after_frames(frames_after_input);
    return Turn::done;
  });
}

std::string ScriptPlayer::value_of(const std::string& name) const {
  if (const auto value = values().find(name)) return *value;
  if (const auto at = name.find("@middle"); at != std::string::npos)
    if (const ControlRecord* control = controls().find(name.substr(0, at)))
      return fmt::format("{:.0f},{:.0f}", (control->min.x + control->max.x) / 2, (control->min.y + control->max.y) / 2);
  fail(fmt::format("there is no value '{}'{}", name, similar_controls(name, Named::any)));
}

std::string ScriptPlayer::expand(const std::string& word) const {
  if (word.size() < 2 || word[0] != '$') return word;
  const auto found = kept_.find(word.substr(1));
  if (found == kept_.end()) fail("nothing was kept as '" + word.substr(1) + "'");
  return found->second;
}

void ScriptPlayer::check_expectation(const Command& command) {
  Expectation wanted;
  const auto& words = command.words;
  if (words.size() == 2) {
    wanted.relation = command.verb == Verb::expect_not ? "!=" : "=";
    wanted.value = expand(words[1]);
  } else {
    wanted.relation = words[1];
    wanted.value = expand(words[2]);
    if (words.size() > 3) wanted.tolerance = parse_script_number(words[3], command.place, {});
  }
  const std::string found = value_of(words[0]);
  if (!fulfils(found, wanted))
    fail(fmt::format("{}: found '{}', expected {} '{}'", words[0], found, wanted.relation, wanted.value));
}

}  // namespace ps::gui
