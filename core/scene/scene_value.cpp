#include "scene/scene_value.h"

#include <cmath>

#include <fmt/format.h>

#include "base/check.h"
#include "base/number_text.h"
#include "math/unit.h"
#include "scene/colour_name.h"
#include "scene/rotation.h"

namespace ps {
namespace {

using Kind = SceneTerm::Kind;
constexpr std::string_view rotation_form = "a rotation such as <45 degrees around the Y axis>";

bool is_words(const SceneTerm& term) { return term.kind == Kind::word || term.kind == Kind::quoted; }

}  // namespace

std::optional<double> parse_finite(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  return parse_number(text);
}

void SceneValues::fail(const SceneTerm& term, const std::string& expected) const {
  throw InputError({file_, term.line, term.column}, term.shown(), expected);
}

void SceneValues::fail_at(int line, int column, const std::string& found, const std::string& expected) const {
  throw InputError({file_, line, column}, found, expected);
}

double SceneValues::number(const SceneTerm& term, std::string_view expected) const {
  if (term.kind != Kind::word) fail(term, std::string(expected));
  const auto value = parse_finite(term.text);
  if (!value) fail(term, std::string(expected));
  if (std::abs(*value) > max_scene_number) fail(term, fmt::format("a number of at most {:g}", max_scene_number));
  return *value;
}

double SceneValues::positive(const SceneTerm& term) const {
  const double value = number(term, "a number greater than 0");
  if (!(value > 0)) fail(term, "a number greater than 0");
  return value;
}

double SceneValues::in_range(const SceneTerm& term, double low, double high) const {
  const std::string expected = fmt::format("a number from {} to {}", low, high);
  const double value = number(term, expected);
  if (!(value >= low && value <= high)) fail(term, expected);
  return value;
}

int SceneValues::whole(const SceneTerm& term, int low, int high) const {
  const std::string expected = fmt::format("a whole number from {} to {}", low, high);
  const double value = number(term, expected);
  if (!(value >= low && value <= high) || std::floor(value) != value) fail(term, expected);
  return static_cast<int>(value);
}

bool SceneValues::on_off(const SceneTerm& term) const {
  if (term.kind == Kind::word && term.text == "on") return true;
  if (term.kind == Kind::word && term.text == "off") return false;
  fail(term, "on or off");
}

std::string SceneValues::name(const SceneTerm& term, std::string_view expected) const {
  if (!is_words(term)) fail(term, std::string(expected));
  if (term.text.empty()) fail(term, fmt::format("{} that is not empty", expected));
  return term.text;
}

const std::vector<SceneTerm>& SceneValues::corners(const SceneTerm& term) const {
  if (!term.is_list() || term.items.size() != 3) fail(term, "three values, one for each vertex");
  return term.items;
}

Vec2d SceneValues::vec2(const SceneTerm& term) const {
  if (term.kind != Kind::tuple || term.items.size() != 2) fail(term, "two numbers in brackets, such as (1, 2)");
  return {number(term.items[0]), number(term.items[1])};
}

Vec3d SceneValues::vec3(const SceneTerm& term) const {
  if (term.kind != Kind::tuple || term.items.size() != 3) fail(term, "three numbers in brackets, such as (1, 2, 3)");
  return {number(term.items[0]), number(term.items[1]), number(term.items[2])};
}

Vec3d SceneValues::direction(const SceneTerm& term) const { return float_direction(side(term)); }

Vec3d SceneValues::side(const SceneTerm& term) const {
  const Vec3d value = vec3(term);
  if (value == Vec3d{0, 0, 0}) fail(term, "a direction other than (0, 0, 0)");
  return value;
}

Vec3d SceneValues::camera_axis(const SceneTerm& term) const {
  const Vec3d value = side(term);
  if (largest_component(value) < min_camera_axis)
    fail(term, fmt::format("a camera axis with a length of at least {:g}", min_camera_axis));
  return value;
}

Vec3d SceneValues::colour(const SceneTerm& term) const {
  if (is_words(term)) {
    if (const auto named = named_colour(term.text)) return *named;
    fail(term, "a colour such as red or (255, 0, 0)");
  }
  const bool linear = term.kind == Kind::linear;
  if ((term.kind != Kind::tuple && !linear) || term.items.size() != 3)
    fail(term, "a colour such as red or (255, 0, 0)");
  Vec3d colour;
  for (int channel = 0; channel < 3; ++channel) {
    const SceneTerm& item = term.items[static_cast<std::size_t>(channel)];
    colour[channel] = linear ? in_range(item, 0, max_scene_number) : in_range(item, 0, 255) / 255.0;
  }
  return colour;
}

Vec2d SceneValues::size(const SceneTerm& term) const {
  const std::string expected = "a size such as 600 x 400";
  Vec2d size;
  if (term.kind == Kind::size) {
    size = {number(term.items[0], expected), number(term.items[1], expected)};
  } else {
    const auto cross = term.text.find('x');
    if (term.kind != Kind::word || cross == std::string::npos) fail(term, expected);
    const auto width = parse_finite(term.text.substr(0, cross));
    const auto height = parse_finite(term.text.substr(cross + 1));
    if (!width || !height) fail(term, expected);
    size = {*width, *height};
  }
  if (!(size.x > 0 && size.y > 0 && size.x <= max_scene_number && size.y <= max_scene_number))
    fail(term, "a size greater than 0 x 0");
  return size;
}

Mat3d SceneValues::rotation(const SceneTerm& term) const {
  if (term.kind == Kind::sequence) {
    Mat3d result(1.0);
    for (const SceneTerm& item : term.items) result = rotation(item) * result;
    return result;
  }
  if (term.kind == Kind::list && term.items.size() == 3)
    return from_rows(vec3(term.items[0]), vec3(term.items[1]), vec3(term.items[2]));
  if (term.kind != Kind::rotation) fail(term, std::string(rotation_form));
  const auto& words = term.items;
  const bool form = words.size() == 6 && (words[1].text == "degrees" || words[1].text == "degree") &&
                    words[2].text == "around" && words[3].text == "the" && words[5].text == "axis";
  if (!form) fail(term, std::string(rotation_form));
  const double degrees = number(words[0], "an angle in degrees");
  const std::string& axis = words[4].text;
  if (axis == "X" || axis == "x") return rotation_about(Axis::x, degrees);
  if (axis == "Y" || axis == "y") return rotation_about(Axis::y, degrees);
  if (axis == "Z" || axis == "z") return rotation_about(Axis::z, degrees);
  fail(words[4], "X, Y or Z");
}

Mat3d SceneValues::frame(const SceneTerm& term) const {
  const Mat3d value = rotation(term);
  for (int column = 0; column < 3; ++column)
    if (largest_component(value[column]) < min_camera_axis)
      fail(term, fmt::format("a rotation with columns of a length of at least {:g}", min_camera_axis));
  return value;
}

std::optional<double> SceneValues::specular(const SceneTerm& term) const {
  const std::string expected = "an exponent greater than 0, or -1 for a matte surface";
  const double exponent = number(term, expected);
  if (exponent == -1) return {};
  if (!(exponent > 0)) fail(term, expected);
  return exponent;
}

Vec3d SceneValues::scale(const SceneTerm& term) const {
  Vec3d scale;
  if (term.kind == Kind::word) {
    scale = Vec3d(number(term, "a number or three in brackets"));
  } else {
    scale = vec3(term);
  }
  if (scale.x == 0 || scale.y == 0 || scale.z == 0) fail(term, "a scale other than 0");
  return scale;
}

}  // namespace ps
