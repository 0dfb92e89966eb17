#include "scene/scene_text.h"

#include <array>
#include <cctype>

#include <fmt/format.h>

#include "base/number_text.h"
#include "scene/rotation.h"

namespace ps {
namespace {

/// The level from 0 to 255 that reads back as this share, in as few digits as possible; empty if there is none.
std::string level_text(double share) {
  for (const int digits : {3, 6, 9, 12, 15, 17}) {
    std::string text = fmt::format("{:.{}g}", share * 255, digits);
    const double level = parse_number(text).value_or(-1);
    if (level >= 0 && level <= 255 && level / 255.0 == share) return text;
  }
  return {};
}

}  // namespace

std::string scene_number(double value) { return fmt::format("{}", value); }

std::string scene_vec(const Vec2d& value) { return fmt::format("({}, {})", value.x, value.y); }

std::string scene_vec(const Vec3d& value) { return fmt::format("({}, {}, {})", value.x, value.y, value.z); }

std::string scene_colour(const Vec3d& colour) {
  const std::array<std::string, 3> levels{level_text(colour.x), level_text(colour.y), level_text(colour.z)};
  for (const std::string& level : levels)
    if (level.empty()) return "linear " + scene_vec(colour);
  return fmt::format("({}, {}, {})", levels[0], levels[1], levels[2]);
}

std::string scene_rotation(const Mat3d& rotation) {
  if (const auto turn = axis_angle_of(rotation)) {
    const std::array<char, 3> letters{'X', 'Y', 'Z'};
    return fmt::format("<{} degrees around the {} axis>", turn->degrees, letters[static_cast<std::size_t>(turn->axis)]);
  }
  return fmt::format("[{}, {}, {}]", scene_vec(row_of(rotation, 0)), scene_vec(row_of(rotation, 1)),
                     scene_vec(row_of(rotation, 2)));
}

std::string scene_name(const std::string& name) {
  bool bare =
      !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0 && name != "linear" && name != "x";
  std::string quoted;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    bare = bare && (std::isalnum(byte) != 0 || c == '_' || c == '-');
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += byte < 0x20 && c != '\t' ? '?' : c;
  }
  return bare ? name : fmt::format("\"{}\"", quoted);
}

}  // namespace ps
