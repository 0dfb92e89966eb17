#include "scene/mtl_texture.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/number_text.h"
#include "scene/obj_line.h"

namespace ps {
namespace {

enum class Takes { numbers, on_off, any_word, reflection_part };

struct MapOption {
  std::string_view word;
  Takes takes = Takes::numbers;
  int least = 1, most = 1;  ///< how many values follow
};
constexpr std::array<MapOption, 14> map_options{{{"-s", Takes::numbers, 1, 3},
                                                 {"-o", Takes::numbers, 1, 3},
                                                 {"-t", Takes::numbers, 1, 3},
                                                 {"-mm", Takes::numbers, 2, 2},
                                                 {"-bm"},
                                                 {"-boost"},
                                                 {"-texres"},
                                                 {"-blendu", Takes::on_off},
                                                 {"-blendv", Takes::on_off},
                                                 {"-cc", Takes::on_off},
                                                 {"-clamp", Takes::on_off},
                                                 {"-imfchan", Takes::any_word},
                                                 {"-colorspace", Takes::any_word},
                                                 {"-type", Takes::reflection_part}}};

constexpr std::array<std::pair<std::string_view, ReflectionPart>, 7> reflection_parts{
    {{"sphere", ReflectionPart::sphere},
     {"cube_top", ReflectionPart::top},
     {"cube_bottom", ReflectionPart::bottom},
     {"cube_front", ReflectionPart::front},
     {"cube_back", ReflectionPart::back},
     {"cube_left", ReflectionPart::left},
     {"cube_right", ReflectionPart::right}}};

const MapOption* find_map_option(std::string_view word) {
  const auto* found = std::find_if(map_options.begin(), map_options.end(),
                                   [&](const MapOption& option) { return option.word == word; });
  return found == map_options.end() ? nullptr : found;
}

ReflectionPart part_named(std::string_view word) {
  for (const auto& [name, part] : reflection_parts)
    if (name == word) return part;
  return ReflectionPart::none;
}

bool fits_option(const MapOption& option, std::string_view word) {
  switch (option.takes) {
  case Takes::numbers:
    return parse_number(word).has_value();
  case Takes::on_off:
    return word == "on" || word == "off";
  case Takes::any_word:
    return !word.empty();
  case Takes::reflection_part:
    return part_named(word) != ReflectionPart::none;
  }
  return false;
}

const char* expected_by(const MapOption& option) {
  switch (option.takes) {
  case Takes::numbers:
    return "a number";
  case Takes::on_off:
    return "on or off";
  case Takes::any_word:
    return "a value of this option";
  case Takes::reflection_part:
    return "sphere, cube_top, cube_bottom, cube_front, cube_back, cube_left or cube_right";
  }
  return "";
}

/// Puts the values of one option into place. Numbers that are left out stay as they are.
void take_values(const MapOption& option, const std::vector<std::string>& values, MtlTexture& map) {
  const auto number = [&](std::size_t i) { return parse_number(values[i]).value_or(0); };
  const auto vector = [&](Vec3d start) {
    for (std::size_t i = 0; i < values.size(); ++i) start[static_cast<int>(i)] = number(i);
    return start;
  };
  if (option.word == "-s") map.scale = vector(map.scale);
  if (option.word == "-o") map.offset = vector(map.offset);
  if (option.word == "-t") map.turbulence = vector({0, 0, 0}) != Vec3d{0, 0, 0};
  if (option.word == "-clamp") map.clamped = values[0] == "on";
  if (option.word == "-bm") map.bump = number(0);
  if (option.word == "-imfchan") map.channel = values[0][0];
  if (option.word == "-type") map.part = part_named(values[0]);
  if (option.word != "-mm") return;
  map.base = number(0);
  map.gain = number(1);
}

/// The option that `line` has just passed.
void read_values(ObjLine& line, const MapOption& option, MtlTexture& map) {
  std::vector<std::string> values;
  for (int i = 0; i < option.most; ++i) {
    ObjLine ahead = line;
    if (i >= option.least && !fits_option(option, ahead.next())) break;
    if (option.takes == Takes::numbers) {
      line.require_number();
    } else if (!fits_option(option, line.next())) {
      line.fail(line.shown(), expected_by(option));
    }
    values.emplace_back(line.word());
  }
  constexpr double most_bump = 1e6;
  if (option.word == "-bm" && std::abs(parse_number(values[0]).value_or(0)) > most_bump)
    line.fail(line.shown(), "a number from -1e6 to 1e6");
  take_values(option, values, map);
}

/// Whether only whole options follow.
bool only_options(ObjLine line) {
  for (std::string_view word = line.next(); !word.empty(); word = line.next()) {
    const MapOption* option = find_map_option(word);
    if (option == nullptr) return false;
    for (int i = 0; i < option->most; ++i) {
      ObjLine ahead = line;
      const bool good = fits_option(*option, ahead.next());
      if (!good && i < option->least) return false;
      if (!good) break;
      line = ahead;
    }
  }
  return true;
}

void read_options(ObjLine& line, MtlTexture& map) {
  for (;;) {
    ObjLine ahead = line;
    const std::string_view word = ahead.next();
    if (word.empty() || word.front() != '-') return;
    line.next();
    const MapOption* option = find_map_option(word);
    if (option == nullptr) line.fail(line.shown(), "an option of a texture, such as -s 1 1 1, or a file name");
    read_values(line, *option, map);
  }
}

/// The name alone, then the options behind it.
void read_name(ObjLine& line, MtlTexture& map) {
  ObjLine ahead = line;
  const std::string rest(ahead.rest());
  const auto quote = rest.empty() || rest.front() != '"' ? std::string::npos : rest.find('"', 1);
  std::size_t length = 0;  // of the words passed, from the beginning of the rest
  const auto start = [&] {
    ObjLine whole = line;
    whole.rest();
    return whole.word().data();
  }();
  ahead = line;
  while (!ahead.next().empty()) {
    length = static_cast<std::size_t>(ahead.word().data() + ahead.word().size() - start);
    if (quote != std::string::npos && length <= quote) continue;
    if (only_options(ahead)) break;
  }
  map.name = rest.substr(0, length);
  if (quote != std::string::npos && quote + 1 == map.name.size()) map.name = map.name.substr(1, quote - 1);
  line = ahead;
  read_options(line, map);
}

}  // namespace

MtlTexture read_mtl_texture(ObjLine& line) {
  MtlTexture map;
  map.line = line.number();
  line.begin_names();
  read_options(line, map);
  ObjLine name = line;
  if (name.rest().empty()) name.fail(name.shown(), "the name of a picture file");
  read_name(line, map);
  if (map.name.empty()) name.fail(name.shown(), "the name of a picture file");
  return map;
}

}  // namespace ps
