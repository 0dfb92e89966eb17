#pragma once
#include <string>
#include <vector>

#include "base/check.h"

namespace ps::gui {

/// The commands of a script. Each line has one; # starts a comment; a word with spaces is put in double quotes
/// (inside them \" and \\ mean themselves and \n a line break).
enum class Verb {
  wait,         ///< wait idle | wait MILLISECONDS | wait frames N | wait until NAME [OPERATOR] VALUE
  set,          ///< set KEY=VALUE, on A
  set_b,        ///< set-b KEY=VALUE
  click_pixel,  ///< click-pixel A|B X,Y
  click,        ///< click CONTROL [left|right|middle|double|ctrl]
  choose,       ///< choose CONTROL KEY: clicks one of a choice, opening the list if it is a drop-down
  drag,         ///< drag CONTROL DX,DY [HOW] | drag X,Y X,Y [HOW]; HOW: another button, or a key held meanwhile
  press,        ///< press [left|right|middle], where the pointer is; the button stays down until lift
  lift,         ///< lift [left|right|middle]
  move,         ///< move CONTROL | move X,Y
  wheel,        ///< wheel STEPS, where the pointer is; up is positive
  type,         ///< type TEXT
  key,          ///< key CHORD
  hold,         ///< hold CHORD
  release,      ///< release CHORD
  open,         ///< open PATH-or-NAME
  drop,         ///< drop PATH, as if dragged into the window
  write,        ///< write PATH TEXT: what another program does to a file meanwhile
  clock,        ///< clock SECONDS: stops the clock by which clicks are quick or slow; else commands are a second apart
  draw,         ///< draw on | draw off: frames are laid out without being drawn, but for screenshots
  screenshot,   ///< screenshot PATH
  expect,       ///< expect NAME VALUE | expect NAME OPERATOR VALUE [TOLERANCE]; OPERATOR is = != ~= < > contains
  expect_not,   ///< expect-not NAME VALUE
  keep,         ///< keep NAME WORD: later $WORD is replaced by the current value of NAME
  print,        ///< print NAME, to standard output; NAME@middle is where a control is
  resize,       ///< resize WxH
  quit          ///< quit
};

struct Command {
  Verb verb = Verb::quit;
  std::vector<std::string> words;  ///< after the verb
  SourcePlace place;
};

/// Throws InputError naming line and column for anything that is not a command with its arguments.
std::vector<Command> parse_script(const std::string& text, const std::string& file);

/// "12.5,-3" as two numbers. Throws InputError.
struct NumberPair {
  double first = 0, second = 0;
};
bool is_number_pair(const std::string& text);
/// The values that a number may have.
struct AllowedRange {
  double low = -1e5, high = 1e5;  ///< places and distances in a window
};
inline constexpr AllowedRange pixel_range{0, 65535}, size_range{1, 16384}, wheel_range{-1000, 1000},
    frames_range{0, 100000}, clock_range{0, 1e6}, milliseconds_range{0, 3600000};
NumberPair parse_number_pair(const std::string& text, const SourcePlace& place, char separator = ',',
                             AllowedRange range = {});
double parse_script_number(const std::string& text, const SourcePlace& place, AllowedRange range);

}  // namespace ps::gui
