#pragma once
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "gui/base/content.h"
#include "gui/platform/events.h"
#include "gui/platform/window.h"
#include "gui/script/script.h"

namespace ps::gui {

/// What the main loop has to do after a step of the script.
struct ScriptStep {
  bool frame = false;  ///< draw one even if nothing happened
  bool ended = false;
  int status = 0;
};

/// What the main loop reports to the script.
struct LoopState {
  bool input_pending = false;  ///< events wait for their frame
  bool idle = false;           ///< nothing to draw, no work going on
};

/// Plays a script upon the real window: everything that a user could do goes through the queue of events. Commands that
/// push events wait until frames have shown their effect.
class ScriptPlayer {
 public:
  /// Throws InputError for a file that cannot be read or parsed.
  explicit ScriptPlayer(const std::string& path);

  /// Called once per turn of the main loop. Failures are printed to standard error with file and line.
  ScriptStep step(Window& window, Content& content, LoopState state);
  /// Whether frame_drawn() may read the next frame.
  bool wants_screenshot() const { return !screenshot_.empty(); }
  /// Whether frames are drawn; otherwise their layout is all that is asked for.
  bool draws() const { return draws_; }
  /// Called when a frame is drawn but not yet shown.
  void frame_drawn(const Window& window);
  /// How long the loop may sleep before the next step(), in seconds.
  double patience() const;

 private:
  using Clock = std::chrono::steady_clock;
  enum class Turn { done, again };
  using Part = std::function<Turn()>;

  void begin(const Command& command);
  void begin_wait(const Command& command);
  void begin_click(const Command& command);
  void go_on_to(Vec2i pixel);
  void begin_choose(const Command& command);
  void begin_drag(const Command& command);
  void check_expectation(const Command& command);
  /// Finds a control, scrolling it into view if need be; then its centre is in `target_`.
  void aim_at(const std::string& name);
  void aim_at_point(double x, double y);
  void press(MouseButton button, int clicks);
  void wait_for_idle();
  void wait_until(const Command& command);
  std::string value_of(const std::string& name) const;
  std::string expand(const std::string& word) const;
  void part(Part part) { parts_.push_back(std::move(part)); }
  /// The next part waits for this many frames.
  void after_frames(int frames) { frames_needed_ = frames; }
  [[noreturn]] void fail(const std::string& message) const;

  std::vector<Command> commands_;
  std::size_t next_ = 0;
  const Command* current_ = nullptr;
  std::deque<Part> parts_;
  int frames_needed_ = 0;
  Clock::time_point wait_until_ = Clock::time_point::min();
  bool watching_ = false;  ///< waits for something that comes by itself
  WindowPoint target_;
  std::string screenshot_;
  bool draws_ = true;
  std::map<std::string, std::string> kept_;
  Window* window_ = nullptr;
  Content* content_ = nullptr;
  LoopState state_;
};

}  // namespace ps::gui
