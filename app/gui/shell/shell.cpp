#include "gui/shell/shell.h"

#include <fmt/format.h>
#include <imgui.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <fstream>
#include <sstream>
#include <thread>
#include <utility>

#include "base/check.h"
#include "base/timer.h"
#include "gui/base/values.h"
#include "gui/input/actions.h"
#include "gui/input/bindings_file.h"
#include "gui/input/key_hint.h"
#include "gui/platform/end_signals.h"
#include "gui/platform/state_file.h"
#include "gui/platform/tracker.h"
#include "gui/platform/window.h"
#include "gui/script/player.h"
#include "gui/shell/help_sheet.h"
#include "gui/shell/palette.h"
#include "gui/theme/projected_type.h"
#include "gui/widgets/key_focus.h"
#include "gui/widgets/redraw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double for_ever = 1e9;
/// Dear ImGui needs a frame to see an event, one to lay out what it opened, and one to settle.
constexpr int frames_after_event = 3;
constexpr std::chrono::microseconds frame_time{16'666};
/// While a study runs and there is no input, frames only show new results: the processor is needed for the study.
constexpr std::chrono::microseconds watching_frame_time{33'333};
constexpr std::chrono::milliseconds hands_off{500};  ///< after the last input

constexpr WindowSize scripted_size{1280, 800};

/// As the window was left the last time.
WindowPlacement remembered_placement(StateFile& state) {
  WindowPlacement placement;
  placement.maximised = state.get("window/maximised") == "yes";
  const std::string remembered = state.get("window/size");
  if (remembered.empty()) return placement;
  char cross = 0;
  WindowSize old;
  std::istringstream text(remembered);
  if (text >> old.width >> cross >> old.height && cross == 'x' && old.width >= 320 && old.height >= 240 &&
      old.width <= 16384 && old.height <= 16384)
    placement.size = old;
  else
    state.complain("window/size", "a size such as 1280x800");
  return placement;
}

/// Since the process began, to a hundredth of a second: what was done before main() counts for one who waits.
double seconds_since_start() {
  std::ifstream file("/proc/self/stat");
  std::string text;
  std::getline(file, text);
  std::istringstream fields(text.substr(std::min(text.size(), text.rfind(')') + 1)));
  constexpr int start_time = 22, first_after_name = 3;  // numbers of the fields, man proc
  std::string skipped;
  for (int field = first_after_name; field < start_time; ++field) fields >> skipped;
  double ticks = 0;
  fields >> ticks;
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9 -
         ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

}  // namespace

/// The mean of the newest times, milliseconds.
class RecentTimes {
 public:
  void add(double milliseconds) {
    sum_ += milliseconds - times_[next_];
    times_[next_] = milliseconds;
    next_ = (next_ + 1) % times_.size();
    count_ = std::min(count_ + 1, times_.size());
  }
  double mean() const { return count_ == 0 ? 0 : sum_ / static_cast<double>(count_); }

 private:
  std::array<double, 30> times_{};
  std::size_t next_ = 0, count_ = 0;
  double sum_ = 0;
};

struct Shell::Impl {
  explicit Impl(const ShellOptions& options)
      : script(options.script.empty() ? nullptr : std::make_unique<ScriptPlayer>(options.script)),
        state(script && !std::getenv("XDG_STATE_HOME") ? std::filesystem::path() : StateFile::default_path()),
        asked_size(options.size.has_value()), remembers_placement(!asked_size && state.remembers()),
        window(options.title, remembers_placement ? remembered_placement(state)
                                                  : WindowPlacement{.size = options.size.value_or(scripted_size)}) {}

  std::unique_ptr<ScriptPlayer> script;  // read first: a bad script must not open a window
  StateFile state;
  std::vector<std::string> complaints;  // about files of the user that were ignored
  bool asked_size;
  bool remembers_placement;
  Window window;
  InputTracker input;
  Actions actions;
  HelpSheet help;
  CommandPalette palette;
  Content* content = nullptr;
  bool ended = false;
  int status = 0;
  int frames_due = frames_after_event;
  std::uint64_t frames = 0, frames_drawn = 0;        // the latter without those that look like the one before
  std::uint64_t turns = 0;                           // of the loop
  Clock::time_point due = Clock::time_point::max();  // of wake_after
  Clock::time_point last_frame, last_input;
  RecentTimes layout_times, frame_times;
  std::function<void(Image<Rgb8>)> shot_taker;  ///< of the next frame

  void add_actions(Shell& shell);
  void offer_values();
  void load_own_keys();
  void take_event(const InputEvent& event);
  void wait(double seconds);
  void rest_between_frames();
  double patience() const;
  void draw_frame();
  void dispatch_keys();
};

void Shell::Impl::offer_values() {
  const auto in_seconds = [](double seconds) { return std::to_string(seconds); };
  // Of the last frames, whose drawing and showing comes after their layout; sleeping in between does not count.
  values().offer("window/layout-ms", [this] { return std::to_string(layout_times.mean()); });
  values().offer("window/frame-ms", [this] { return std::to_string(frame_times.mean()); });
  values().offer("window/size", [this] { return fmt::format("{}x{}", window.size().width, window.size().height); });
  values().offer("window/place", [this] {
    const auto [x, y] = window.position();
    return fmt::format("{},{}", x, y);
  });
  const auto on_off = [](bool on) { return std::string(on ? "on" : "off"); };
  values().offer("window/maximised", [=, this] { return on_off(window.maximised()); });
  values().offer("window/fullscreen", [=, this] { return on_off(window.fullscreen()); });
  values().offer("window/visible", [=, this] { return on_off(window.visible()); });
  values().offer("window/tooltip", [=] { return on_off(tooltip_visible()); });
  values().offer("window/tooltip-end", tooltip_end);
  values().offer("window/turns", [this] { return std::to_string(turns); });
  values().offer("keyboard/at", [] { return key_focus().place(); });
  // "F2=mode-lesson X=split": what keys do now; two names with a "+" would be two meanings of one key.
  values().offer("keys/meanings", [this] {
    std::string all;
    for (const Actions::Meaning& meaning : actions.meanings()) {
      all += (all.empty() ? "" : " ") + chord_text(meaning.chord) + "=";
      for (const std::string& name : meaning.actions) all += (all.ends_with('=') ? "" : "+") + name;
    }
    return all;
  });
  values().offer("keys/last", [this] { return actions.last_by_key(); });
  values().offer("clipboard", [this] { return window.clipboard(); });
  values().offer("window/seconds", [=] { return in_seconds(seconds_since_start()); });
  values().offer("window/cpu-seconds",
                 [=] { return in_seconds(static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC)); });
}

Shell::Shell(const ShellOptions& options) : impl_(std::make_unique<Impl>(options)) {
  double scale = options.scale.value_or(0);
  if (scale <= 0) scale = impl_->state.number("window/scale", Theme::min_scale, Theme::max_scale);
  if (scale <= 0) scale = !options.script.empty() ? 1 : impl_->window.display_lines() > 2000 ? 2 : 1;
  theme().set_scale(scale);
  theme().set_brightness(remembered("window/theme") == "dark" ? Brightness::dark : Brightness::light);
  impl_->complaints = impl_->state.complaints();
  impl_->add_actions(*this);
  impl_->offer_values();
}

Shell::~Shell() { set_key_hints(nullptr); }

void Shell::Impl::add_actions(Shell& shell) {
  const auto zoom = [&shell](double factor) {
    theme().set_scale(factor > 0 ? theme().scale() * factor : 1);
    shell.remember("window/scale", fmt::format("{}", theme().scale()));
    shell.wake();
  };
  ActionGroup group(actions, "Window");
  group.add("help", "Keys and commands", "? F1", [this] { help.toggle(); });
  group.add("palette", "Find a command", "Ctrl+K", [this] { palette.open(); });
  group.add("larger-type", "Larger text", "Ctrl++ Ctrl+= Ctrl+KeypadPlus", [zoom] { zoom(1.125); });
  group.add("smaller-type", "Smaller text", "Ctrl+- Ctrl+KeypadMinus", [zoom] { zoom(1 / 1.125); });
  group.add("standard-type", "Standard text size", "Ctrl+0", [zoom] { zoom(0); });
  const auto turn_theme = [&shell] {
    const bool dark = theme().brightness() == Brightness::dark;
    theme().set_brightness(dark ? Brightness::light : Brightness::dark);
    shell.remember("window/theme", dark ? "light" : "dark");
    shell.wake();
  };
  group.add_toggle("dark-theme", "Dark theme", "", turn_theme, [] { return theme().brightness() == Brightness::dark; });
  group.add_toggle(
      "fullscreen", "Full screen", "F11", [&shell] { shell.set_fullscreen(!shell.fullscreen()); },
      [&shell] { return shell.fullscreen(); });
  group.add("focus-next", "Keyboard into the panels, and on", "F6", [] { key_focus().go_to_region(1); });
  group.add("focus-before", "Keyboard to the panel before", "Shift+F6", [] { key_focus().go_to_region(-1); });
  group.add("quit", "Quit", "Ctrl+Q", [this] {
    if (content->may_close()) ended = true;
  });
}

/// The user's own keys. A script presses the standard ones.
void Shell::Impl::load_own_keys() {
  if (script) return;
  const std::string complaint = load_bindings(config_file("keys.conf"), actions);
  if (!complaint.empty()) complaints.push_back(complaint);
}

void Shell::Impl::take_event(const InputEvent& event) {
  input.take(event);
  // While something is dragged over the window no movements are reported, but a script's pointer is not the real one.
  if (event.kind == InputEvent::Kind::drop)
    content->drop(event.text, script ? std::nullopt : std::optional(window.pointer()));
  if (event.kind == InputEvent::Kind::close && content->may_close()) ended = true;
}

/// Takes what comes within `seconds`, and notes how many frames it needs.
void Shell::Impl::wait(double seconds) {
  bool input_came = false;
  const bool any = window.wait_events(seconds, [&](const InputEvent& event) {
    input_came = true;
    take_event(event);
  });
  if (!any) return;
  if (input_came) last_input = Clock::now();
  // What work has made so far needs one frame; its end, and all that hands do, may move things, which need some more.
  frames_due = std::max(frames_due, input_came || !content->busy() ? frames_after_event : 1);
}

/// Without vertical sync, frames would follow one another as fast as they can.
void Shell::Impl::rest_between_frames() {
  const auto asked = last_input;
  const bool watching = content->busy() && !content->animating() && Clock::now() - last_input > hands_off;
  const auto until = last_frame + (watching ? watching_frame_time : frame_time);
  while (true) {
    const double rest = std::chrono::duration<double>(until - Clock::now()).count();
    if (rest <= 0) return;
    if (!watching) return std::this_thread::sleep_for(until - Clock::now());
    wait(rest);
    if (last_input != asked) return;
  }
}

double Shell::Impl::patience() const {
  if (!window.visible()) return script ? script->patience() : for_ever;
  if (frames_due > 0 || input.pending() || content->animating()) return 0;
  const auto now = Clock::now();
  double seconds = due == Clock::time_point::max() ? for_ever : std::chrono::duration<double>(due - now).count();
  if (script) seconds = std::min(seconds, script->patience());
  return std::max(seconds, 0.0);
}

void Shell::Impl::dispatch_keys() {
  if (input.lost_focus()) actions.release_all();
  const bool typing = ImGui::GetIO().WantTextInput;
  for (const KeyChange& key : input.keys()) {
    const Chord chord = key.key.first();
    if (key.down) hide_tooltip();
    if (!key.down)
      actions.key_up(key.key.at_place.key);
    else if (!help.take_key(chord) && !palette.is_open() && (typing || !key_focus().take_key(chord, key.repeat)))
      actions.key_down(key.key, key.repeat, typing);
  }
}

void Shell::Impl::draw_frame() {
  const Timer timer;
  if (prepare_themes()) window.fonts_changed();
  window.begin_frame();
  input.apply(ImGui::GetIO());
  ImGui::NewFrame();
  dispatch_keys();
  content->draw();
  key_focus().end_frame();
  help.draw(actions);
  palette.draw(actions);
  ImGui::Render();
  layout_times.add(timer.milliseconds());
  const bool will_be_read = shot_taker || (script && script->wants_screenshot());
  const bool drawn = (will_be_read || !script || script->draws()) && window.draw_frame(will_be_read);
  if (const auto take = std::exchange(shot_taker, {})) take(window.screenshot());
  if (script) script->frame_drawn(window);
  if (drawn) {
    window.show_frame();
    ++frames_drawn;
  }
  frame_times.add(timer.milliseconds());
  if (frames == 0) values().publish("window/first-frame-ms", seconds_since_start() * 1000);
  values().publish("window/frames", ++frames);
  values().publish("window/frames-drawn", frames_drawn);
  values().publish("window/scale", theme().scale());
  values().publish("window/theme", theme().brightness() == Brightness::dark ? "dark" : "light");
  if (const double wish = take_redraw_wish(); wish >= 0) {
    const auto delay = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(wish));
    due = std::min(due, Clock::now() + delay);
  }
}

int Shell::run(Content& content) {
  Impl& my = *impl_;
  my.content = &content;
  my.load_own_keys();
  set_key_hints(&my.actions);
  for (const std::string& complaint : my.complaints) content.warn(complaint);
  while (!my.ended) {
    if (const int signal = end_signal(); signal != 0) {
      content.ended_from_outside();
      my.status = 128 + signal;  // as shells report it
      break;
    }
    const double seconds = my.patience();
    if (seconds == 0 && !my.script) my.rest_between_frames();
    my.wait(seconds);
    if (my.due <= Clock::now()) {
      my.due = Clock::time_point::max();
      my.frames_due = std::max(my.frames_due, 1);
    }
    bool asked_for = false;  // a frame, by the script
    ++my.turns;
    if (my.script) {
      const bool draws = my.window.visible();  // what waits for a frame waits on while nobody sees it
      const bool pending = draws && my.input.pending();
      const bool idle = !(draws && (my.frames_due > 0 || content.animating())) && !pending && !content.busy();
      const ScriptStep step = my.script->step(my.window, content, {.input_pending = pending, .idle = idle});
      my.wait(0);  // what the step pushed
      if (step.frame) my.frames_due = std::max(my.frames_due, 1);
      asked_for = step.frame;
      if (step.ended) {
        my.status = step.status;
        break;
      }
    }
    if (!my.window.visible() && !asked_for) continue;
    if (my.frames_due == 0 && !my.input.pending() && !content.animating()) continue;
    my.last_frame = Clock::now();
    my.frames_due = std::max(0, my.frames_due - 1);
    my.draw_frame();
  }
  if (my.remembers_placement) {
    const WindowPlacement left = my.window.placement();
    remember("window/size", fmt::format("{}x{}", left.size.width, left.size.height));
    remember("window/maximised", left.maximised ? "yes" : "no");
  }
  my.state.save();
  return my.status;
}

void Shell::wake() { Window::wake(); }

void Shell::wake_after(double seconds) {
  const auto then = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  impl_->due = std::min(impl_->due, then);
}

void Shell::quit(int status) {
  impl_->ended = true;
  impl_->status = status;
}

Actions& Shell::actions() { return impl_->actions; }
void Shell::take_shot(std::function<void(Image<Rgb8>)> take) {
  impl_->shot_taker = std::move(take);
  wake();
}
void Shell::set_fullscreen(bool on) { impl_->window.set_fullscreen(on); }
bool Shell::fullscreen() const { return impl_->window.fullscreen(); }
bool Shell::has_asked_size() const { return impl_->asked_size; }
void Shell::set_title(const std::string& title) { impl_->window.set_title(title); }
std::string Shell::clipboard() const { return impl_->window.clipboard(); }
void Shell::set_clipboard(const std::string& text) { impl_->window.set_clipboard(text); }
std::string Shell::remembered(const std::string& key) const { return impl_->state.get(key); }
bool Shell::remembers() const { return impl_->state.remembers(); }
void Shell::remember(const std::string& key, std::string value) { impl_->state.set(key, std::move(value)); }
void Shell::remember_lines(const std::string& key, std::string lines) { impl_->state.set_lines(key, std::move(lines)); }

}  // namespace ps::gui
