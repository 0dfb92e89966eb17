#include "gui/script/script.h"

#include <algorithm>
#include <array>
#include <sstream>

#include <fmt/format.h>

#include "base/number_text.h"
#include "gui/input/actions.h"

namespace ps::gui {
namespace {

struct VerbRow {
  std::string_view name;
  Verb verb;
  std::size_t fewest, most;  ///< words
  std::string_view usage;
};

constexpr std::array verbs{
    VerbRow{"wait", Verb::wait, 1, 4,
            "wait idle, wait MILLISECONDS, wait frames N or wait until NAME [OPERATOR] VALUE"},
    VerbRow{"set", Verb::set, 1, 1, "set KEY=VALUE"},
    VerbRow{"set-b", Verb::set_b, 1, 1, "set-b KEY=VALUE"},
    VerbRow{"click-pixel", Verb::click_pixel, 2, 2, "click-pixel A|B X,Y"},
    VerbRow{"click", Verb::click, 1, 2, "click CONTROL [left|right|middle|double|ctrl]"},
    VerbRow{"choose", Verb::choose, 2, 2, "choose CONTROL KEY"},
    VerbRow{"drag", Verb::drag, 2, 3, "drag CONTROL DX,DY or drag X,Y X,Y, then [left|right|middle|alt|ctrl|shift]"},
    VerbRow{"press", Verb::press, 0, 1, "press [left|right|middle]"},
    VerbRow{"lift", Verb::lift, 0, 1, "lift [left|right|middle]"},
    VerbRow{"move", Verb::move, 1, 1, "move CONTROL or move X,Y"},
    VerbRow{"wheel", Verb::wheel, 1, 1, "wheel STEPS"},
    VerbRow{"type", Verb::type, 1, 1, "type TEXT"},
    VerbRow{"key", Verb::key, 1, 1, "key CHORD"},
    VerbRow{"hold", Verb::hold, 1, 1, "hold CHORD"},
    VerbRow{"release", Verb::release, 1, 1, "release CHORD"},
    VerbRow{"open", Verb::open, 1, 1, "open PATH-or-NAME"},
    VerbRow{"drop", Verb::drop, 1, 1, "drop PATH"},
    VerbRow{"write", Verb::write, 2, 2, "write PATH TEXT"},
    VerbRow{"clock", Verb::clock, 1, 1, "clock SECONDS"},
    VerbRow{"draw", Verb::draw, 1, 1, "draw on or draw off"},
    VerbRow{"screenshot", Verb::screenshot, 1, 1, "screenshot PATH"},
    VerbRow{"expect", Verb::expect, 2, 4, "expect NAME [=|!=|~=|<|>|contains] VALUE [TOLERANCE]"},
    VerbRow{"expect-not", Verb::expect_not, 2, 2, "expect-not NAME VALUE"},
    VerbRow{"keep", Verb::keep, 2, 2, "keep NAME WORD"},
    VerbRow{"print", Verb::print, 1, 1, "print NAME"},
    VerbRow{"resize", Verb::resize, 1, 1, "resize WxH"},
    VerbRow{"quit", Verb::quit, 0, 0, "quit"},
};

constexpr std::array operators{"=", "!=", "~=", "<", ">", "contains"};
constexpr std::array click_kinds{"left", "right", "middle", "double", "ctrl"};
constexpr std::array drag_kinds{"left", "right", "middle", "alt", "ctrl", "shift"};
constexpr std::array buttons{"left", "right", "middle"};
constexpr std::array on_off{"on", "off"};

struct Word {
  std::string text;
  int column = 1;
};

std::vector<Word> split_line(const std::string& line, SourcePlace place) {
  std::vector<Word> words;
  for (std::size_t i = 0; i < line.size();) {
    if (line[i] == ' ' || line[i] == '\t' || line[i] == '\r') {
      ++i;
      continue;
    }
    if (line[i] == '#') break;
    Word word;
    word.column = static_cast<int>(i) + 1;
    if (line[i] != '"') {
      while (i < line.size() && line[i] != ' ' && line[i] != '\t' && line[i] != '\r') word.text += line[i++];
      words.push_back(std::move(word));
      continue;
    }
    bool closed = false;
    for (++i; i < line.size() && !closed; ++i) {
      if (line[i] == '"')
        closed = true;
      else if (line[i] == '\\' && i + 1 < line.size())
        word.text += line[++i] == 'n' ? '\n' : line[i];
      else
        word.text += line[i];
    }
    if (!closed) {
      place.column = word.column;
      throw InputError(place, "a quotation mark without its partner", "\"text\"");
    }
    words.push_back(std::move(word));
  }
  return words;
}

void require_one_of(const std::string& word, const auto& allowed, const SourcePlace& place, std::string_view usage) {
  if (std::find(allowed.begin(), allowed.end(), word) == allowed.end())
    throw InputError(place, "'" + word + "'", std::string(usage));
}

/// Checks what can be checked before the window opens.
void check(const Command& command, std::string_view usage) {
  const auto& words = command.words;
  switch (command.verb) {
  case Verb::wait:
    if (words[0] == "frames") {
      if (words.size() != 2) throw InputError(command.place, "wait frames", std::string(usage));
      parse_script_number(words[1], command.place, frames_range);
    } else if (words[0] == "until") {
      if (words.size() < 3) throw InputError(command.place, "wait until", std::string(usage));
      if (words.size() == 4) require_one_of(words[2], operators, command.place, usage);
    } else if (words.size() != 1)
      throw InputError(command.place, "'" + words[1] + "'", std::string(usage));
    else if (words[0] != "idle")
      parse_script_number(words[0], command.place, milliseconds_range);
    break;
  case Verb::click_pixel:
    require_one_of(words[0], std::array{"A", "B"}, command.place, usage);
    parse_number_pair(words[1], command.place, ',', pixel_range);
    break;
  case Verb::click:
    if (words.size() == 2) require_one_of(words[1], click_kinds, command.place, usage);
    break;
  case Verb::drag:
    parse_number_pair(words[1], command.place);
    if (words.size() == 3) require_one_of(words[2], drag_kinds, command.place, usage);
    break;
  case Verb::press:
  case Verb::lift:
    if (words.size() == 1) require_one_of(words[0], buttons, command.place, usage);
    break;
  case Verb::draw:
    require_one_of(words[0], on_off, command.place, usage);
    break;
  case Verb::wheel:
    parse_script_number(words[0], command.place, wheel_range);
    break;
  case Verb::clock:
    parse_script_number(words[0], command.place, clock_range);
    break;
  case Verb::key:
  case Verb::hold:
  case Verb::release:
    try {
      parse_chord(words[0]);
    } catch (const InputError&) {
      throw InputError(command.place, "'" + words[0] + "'", "a key such as Ctrl+Shift+Z, F11, PageDown or [");
    }
    break;
  case Verb::expect:
    if (words.size() > 2) require_one_of(words[1], operators, command.place, usage);
    if (words.size() > 3) parse_script_number(words[3], command.place, {});
    break;
  case Verb::resize:
    parse_number_pair(words[0], command.place, 'x', size_range);
    break;
  case Verb::set:
  case Verb::set_b:
    if (words[0].find('=') == std::string::npos)
      throw InputError(command.place, "'" + words[0] + "'", std::string(usage));
    break;
  case Verb::choose:
  case Verb::move:
  case Verb::type:
  case Verb::open:
  case Verb::drop:
  case Verb::write:
  case Verb::screenshot:
  case Verb::expect_not:
  case Verb::keep:
  case Verb::print:
  case Verb::quit:
    break;
  }
}

}  // namespace

double parse_script_number(const std::string& text, const SourcePlace& place, AllowedRange range) {
  const auto value = parse_number(text);
  if (!value || *value < range.low || *value > range.high)
    throw InputError(place, "'" + text + "'", fmt::format("a number from {} to {}", range.low, range.high));
  return *value;
}

NumberPair parse_number_pair(const std::string& text, const SourcePlace& place, char separator, AllowedRange range) {
  const auto middle = text.find(separator);
  if (middle == std::string::npos)
    throw InputError(place, "'" + text + "'", std::string("two numbers with '") + separator + "' between them");
  return {parse_script_number(text.substr(0, middle), place, range),
          parse_script_number(text.substr(middle + 1), place, range)};
}

bool is_number_pair(const std::string& text) {
  try {
    parse_number_pair(text, {});
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::vector<Command> parse_script(const std::string& text, const std::string& file) {
  std::vector<Command> commands;
  std::istringstream lines(text);
  SourcePlace place{file, 0, 1};
  for (std::string line; std::getline(lines, line);) {
    ++place.line;
    place.column = 1;
    auto words = split_line(line, place);
    if (words.empty()) continue;
    place.column = words[0].column;
    const auto row =
        std::find_if(verbs.begin(), verbs.end(), [&](const VerbRow& v) { return v.name == words[0].text; });
    if (row == verbs.end()) {
      std::string known = "one of";
      for (const VerbRow& verb : verbs) known += " " + std::string(verb.name);
      throw InputError(place, "'" + words[0].text + "'", known);
    }
    const std::size_t count = words.size() - 1;
    if (count < row->fewest || count > row->most) {
      if (count > row->most) place.column = words[row->most + 1].column;
      throw InputError(place, std::to_string(count) + " words after " + words[0].text, std::string(row->usage));
    }
    Command command{row->verb, {}, place};
    if (count > 0) command.place.column = words[1].column;
    for (std::size_t i = 1; i < words.size(); ++i) command.words.push_back(std::move(words[i].text));
    check(command, row->usage);
    commands.push_back(std::move(command));
  }
  return commands;
}

}  // namespace ps::gui
