#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "base/input_errors.h"
#include "options/scene_settings.h"
#include "scene/scene_file.h"
#include "support/refusal.h"

namespace scene_errors_test {
namespace {

using ps::test::refusal_of;

struct BadScene {
  const char* name;
  std::string text;
  int line, column;
  const char* found;
  const char* expected;
  friend std::ostream& operator<<(std::ostream& out, const BadScene& bad) { return out << bad.name; }
};

class SceneErrors : public testing::TestWithParam<BadScene> {};

TEST_P(SceneErrors, NamePlaceFoundAndExpected) {
  const BadScene& bad = GetParam();
  EXPECT_EQ(refusal_of([&] { ps::settings_for(ps::parse_scene(bad.text, "bad.scene", ".")); }),
            fmt::format("bad.scene:{}:{}: found {}, expected {}", bad.line, bad.column, bad.found, bad.expected));
}

const std::string model = "model { name = m vertices { (0,0,0) (1,0,0) (0,1,0) }\n";
constexpr const char* rotation_form = "a rotation such as <45 degrees around the Y axis>";

INSTANTIATE_TEST_SUITE_P(
    Notation, SceneErrors,
    testing::Values(
        BadScene{"unknown_key", "sphere {\n  center = (0, 0, 3)\n  raduis = 1\n}", 3, 3,
                 "unknown key 'raduis' in sphere", "'radius'"},
        BadScene{"unknown_block", "spheer { }", 1, 1, "unknown key 'spheer' in a scene", "'sphere'"},
        BadScene{"missing_value_before_key", "sphere {\n  center = (0, 0, 3)\n  radius =\n  color = red }", 4, 3,
                 "'color'", "a value for 'radius'"},
        BadScene{"missing_value_before_brace", "sphere { radius = }", 1, 19, "'}'", "a value for 'radius'"},
        BadScene{"missing_value_at_end", "viewport_size =", 1, 16, "the end of the file",
                 "a value for 'viewport_size'"},
        BadScene{"missing_equals", "sphere { radius 1 }", 1, 17, "'1'", "'=' or '{' after 'radius'"},
        BadScene{"missing_key", "# eyes\n\nsphere { center = (0, 0, 3) }", 3, 1, "sphere without 'radius'",
                 "'radius = ...' in it"},
        BadScene{"nan", "sphere { center = (0, nan, 3) radius = 1 }", 1, 23, "'nan'", "a number"},
        BadScene{"inf", "sphere { center = (0, 0, inf) radius = 1 }", 1, 26, "'inf'", "a number"},
        BadScene{"overflow", "projection_plane_d = 1e999", 1, 22, "'1e999'", "a number greater than 0"},
        BadScene{"too_large", "sphere { center = (0, 0, 1e20) radius = 1 }", 1, 26, "'1e20'",
                 "a number of at most 1e+12"},
        BadScene{"hexadecimal", "projection_plane_d = 0x10", 1, 22, "'0x10'", "a number greater than 0"},
        BadScene{"negative_radius", "sphere { center = (0, 0, 3) radius = -1 }", 1, 38, "'-1'",
                 "a number greater than 0"},
        BadScene{"zero_radius", "sphere { center = (0, 0, 3) radius = 0 }", 1, 38, "'0'", "a number greater than 0"},
        BadScene{"zero_direction", "light { type = directional intensity = 1 direction = (0, 0, 0) }", 1, 54,
                 "'(0, 0, 0)'", "a direction other than (0, 0, 0)"},
        BadScene{"unclosed_brace", "light { type = ambient intensity = 1 }\nsphere {\n  radius = 1\n", 2, 8,
                 "'{' that is not closed", "'}' before the end of the file"},
        BadScene{"unclosed_bracket", "sphere { center = (0, 1", 1, 19, "'(' that is not closed",
                 "',' or ')' before the end of the file"},
        BadScene{"brace_too_many", "sphere { center = (0,0,3) radius = 1 }\n}", 2, 1, "'}'", "a key"},
        BadScene{"two_coordinates", "sphere { center = (0, 1) radius = 1 }", 1, 19, "'(0, 1)'",
                 "three numbers in brackets, such as (1, 2, 3)"},
        BadScene{"unknown_model", model + "triangles { 0, 1, 2 } }\ninstance { model = n }", 3, 20, "'n'",
                 "a model defined before this line, such as 'm'"},
        BadScene{"no_model_at_all", "instance { model = n }", 1, 20, "'n'", "a model defined before this line"},
        BadScene{"unknown_texture", "sphere { center = (0,0,3) radius = 1 texture = wood }", 1, 48, "'wood'",
                 "a texture defined before this line"},
        BadScene{"index_out_of_range", model + "triangles { 0 = 0, 1, 3, red } }", 2, 23, "'3'",
                 "a vertex of the model, which has 3"},
        BadScene{"negative_index", model + "triangles { 0 = 0, 1, -1, red } }", 2, 23, "'-1'",
                 "a vertex of the model, which has 3"},
        BadScene{"unknown_colour", "background = rouge", 1, 14, "'rouge'", "a colour such as red or (255, 0, 0)"},
        BadScene{"colour_beyond_255", "background = (0, 256, 0)", 1, 18, "'256'", "a number from 0 to 255"},
        BadScene{"reflective_beyond_1", "sphere { center = (0,0,3) radius = 1 reflective = 1.5 }", 1, 51, "'1.5'",
                 "a number from 0 to 1"},
        BadScene{"specular_zero", "sphere { center = (0,0,3) radius = 1 specular = 0 }", 1, 49, "'0'",
                 "an exponent greater than 0, or -1 for a matte surface"},
        BadScene{"second_key", "sphere {\n radius = 1\n radius = 2 }", 3, 2, "a second 'radius'",
                 "the one in line 2 only"},
        BadScene{"second_background", "background = red\nbackground = blue", 2, 1, "a second 'background'",
                 "the one in line 1 only"},
        BadScene{"second_model", model + "triangles { 0, 1, 2 } }\n" + model + "triangles { 0, 1, 2 } }", 3, 16, "'m'",
                 "a name that no other model has"},
        BadScene{"second_object",
                 "sphere { name = a center = (0,0,3) radius = 1 }\nsphere { name = a center = (0,0,3) radius = 1 }", 2,
                 17, "'a'", "a name other than that in line 1"},
        BadScene{"light_without_type", "light { intensity = 1 }", 1, 1, "light without 'type'", "'type = ...' in it"},
        BadScene{"unknown_light", "light { type = sun intensity = 1 }", 1, 16, "'sun'",
                 "ambient, point or directional"},
        BadScene{"ambient_position", "light { type = ambient intensity = 1 position = (0,0,0) }", 1, 38, "'position'",
                 "no position or direction: ambient light has none"},
        BadScene{"rotation_axis",
                 model + "triangles { 0, 1, 2 } }\ninstance { model = m transform { rotation = "
                         "<45 degrees around the W axis> } }",
                 3, 68, "'W'", "X, Y or Z"},
        BadScene{"rotation_without_unit",
                 model + "triangles { 0, 1, 2 } }\ninstance { model = m transform { rotation = "
                         "<45> } }",
                 3, 45, "'<45>'", rotation_form},
        BadScene{"scale_zero", model + "triangles { 0, 1, 2 } }\ninstance { model = m transform { scale = 0 } }", 3, 42,
                 "'0'", "a scale other than 0"},
        BadScene{"unknown_setting", "settings { shadow-epsilom = 0 }", 1, 12,
                 "unknown key 'shadow-epsilom' in settings", "'shadow-epsilon'"},
        BadScene{"setting_value", "settings { shading = round }", 1, 22, "'round'", "one of phong gouraud flat"},
        BadScene{"setting_range", "settings { reflection-depth = 65 }", 1, 31, "'65'", "a whole number from 0 to 64"},
        BadScene{"size_zero", "canvas_size = 0 x 0", 1, 15, "'0 x 0'", "a size greater than 0 x 0"},
        BadScene{"size_huge", "canvas_size = 100000x100000", 1, 15, "'100000x100000'", "at most 268435456 pixels"},
        BadScene{"missing_include", "include = none.scene", 1, 11, "'none.scene'",
                 "a file that can be read (none.scene: found no such file, expected a file)"},
        BadScene{"open_quotation", "title = \"no end\n", 1, 9, "a quotation mark that is not closed",
                 "a closing quotation mark on the same line"},
        BadScene{"nul", std::string("title = a\0b", 11), 1, 10, "the control character 0x00", "text"},
        BadScene{"utf16", std::string("\xFF\xFEs\0", 4), 1, 1, "UTF-16 text", "UTF-8 text"},
        BadScene{"column_counts_characters", "title = \"Räume\" titel = 1", 1, 17, "unknown key 'titel' in a scene",
                 "'title'"}),
    [](const auto& bad) { return std::string(bad.param.name); });

/// Lines and columns of all errors of a scene.
std::vector<std::string> errors_of(const std::string& text) {
  std::vector<std::string> places;
  try {
    ps::parse_scene(text, "bad.scene", ".");
  } catch (const ps::InputErrors& errors) {
    for (const ps::InputError& error : errors.all())
      places.push_back(fmt::format("{}:{}", error.place().line, error.place().column));
  }
  return places;
}

TEST(SceneErrors, UpToFiveAtOnce) {
  using Places = std::vector<std::string>;
  const std::string bad = "sphere { center = (0, 0, 3) radius = -1 }\n", good = "background = red\n";
  EXPECT_EQ(errors_of(good + bad + bad), (Places{"2:38", "3:38"}));
  std::string many;
  for (int i = 0; i < 7; ++i) many += bad;
  EXPECT_EQ(errors_of(many), (Places{"1:38", "2:38", "3:38", "4:38", "5:38"}));
  // An error inside a group does not change what is around the next one.
  std::string groups;
  for (int i = 0; i < 4; ++i) groups += "group { group { " + bad + "} }\n";
  EXPECT_EQ(errors_of(groups), (Places{"1:54", "3:54", "5:54", "7:54"}));
}

TEST(SceneErrors, WhatMissesALostNameIsNotOne) {
  using Places = std::vector<std::string>;
  EXPECT_EQ(errors_of("material { name = m color = rde }\n"
                      "sphere { center = (0, 0, 3) radius = 1 material = m }\n"
                      "sphere { center = (0, 0, 3) radius = 1 material = other }\n"),
            (Places{"1:29", "3:51"}));
}

TEST(SceneErrors, NestingIsLimited) {
  const std::string deep(1'000'000, '(');
  const std::string words = refusal_of([&] { ps::parse_scene("background = " + deep, "deep.scene", "."); });
  EXPECT_TRUE(words.starts_with("deep.scene:1:46: ") && words.ends_with("expected at most 32 nested brackets"))
      << words.substr(0, 200);
}

/// The text must be refused for what it asks for as a whole, at this line.
void expect_too_much(const std::string& text, int line, const std::string& found) {
  const std::string words = refusal_of([&] { ps::parse_scene(text, "greedy.scene", "."); });
  EXPECT_TRUE(words.starts_with(fmt::format("greedy.scene:{}:", line))) << words;
  EXPECT_NE(words.find(": found " + found + ", expected "), std::string::npos) << words;
}

TEST(SceneErrors, AShortFileCannotAskForAnyAmountOfMemory) {
  std::string instances = "model { name = m sphere_divisions = 200 }\n";
  const std::size_t each = ps::parse_scene(instances, "m.scene", ".").geometry->meshes[0]->triangles.size();
  const auto most = 16'000'000 / each - 1;  // the model itself counts once
  for (std::size_t i = 0; i <= most; ++i) instances += "instance { model = m position = (0, 0, 9) }\n";
  expect_too_much(instances, static_cast<int>(most) + 2,
                  std::to_string((most + 2) * each) + " triangles by 'instance'");
}

TEST(SceneErrors, UnclosedBraceInsideAnotherNamesTheInner) {
  EXPECT_TRUE(refusal_of([] {
                ps::parse_scene("model {\n  vertices {\n    0 = (1, 2, 3)\n", "open.scene", ".");
              }).starts_with("open.scene:2:12: "));
}

}  // namespace
}  // namespace scene_errors_test
