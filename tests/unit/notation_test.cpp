// The page about the notation of scenes, against the parser: the table of a block has the fields that it takes, alone;
// and each example gives its picture.
#include "scene/notation.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>

#include <map>
#include <regex>
#include <set>

#include "base/read_file.h"
#include "frame/display_frame.h"
#include "image/file.h"
#include "options/scene_settings.h"
#include "scene/scene_file.h"
#include "support/refusal.h"
#include "support/render_once.h"

namespace ps::notation_test {
namespace {

/// A scene in which the construct is given the field, which stands where this has an @.
const std::map<std::string, std::string>& places() {
  static const std::map<std::string, std::string> all{
      {"scene", "@"},
      {"camera", "camera { @ }"},
      {"light", "light { @ }"},
      {"material", "material { @ }"},
      {"texture", "texture { @ }"},
      {"sphere", "sphere { @ }"},
      {"plane", "plane { @ }"},
      {"rectangle", "rectangle { @ }"},
      {"box", "box { @ }"},
      {"cylinder", "cylinder { @ }"},
      {"difference",
       "difference { sphere { center = (0, 0, 0) radius = 1 } sphere { center = (1, 0, 0) radius = 1 } @ }"},
      {"group", "group { @ }"},
      {"transform", "model { name = m sphere_divisions = 3 } instance { model = m transform { @ } }"},
      {"model", "model { @ }"},
      {"triangle of a model",
       "model { name = m vertices { (0, 0, 0) (1, 0, 0) (0, 1, 0) } triangles { 0 = { vertices = [0, 1, 2] @ } } }"},
      {"instance", "instance { @ }"},
      {"triangle", "triangle { vertices = ((0, 0, 0), (1, 0, 0), (0, 1, 0)) @ }"},
      {"polygon", "polygon { vertices = ((0, 0, 0), (1, 0, 0), (0, 1, 0)) @ }"},
      {"line", "line { @ }"},
      {"triangle on the canvas", "triangle { vertices = ((0, 0), (1, 0), (0, 1)) @ }"},
      {"polygon on the canvas", "polygon { vertices = ((0, 0), (1, 0), (0, 1)) @ }"}};
  return all;
}

bool is_known(const std::string& part, const std::string& key) {
  std::string text = places().at(part);
  text.replace(text.find('@'), 1, key + " = 1");
  const std::string refused = test::refusal_of([&] { parse_scene(text, "probe.scene", "."); });
  return refused.find("unknown key '" + key + "'") == std::string::npos;
}

/// Every word in quotes of the files that read scenes: more than all keys.
std::set<std::string> words_of_parser() {
  std::set<std::string> words;
  for (const auto& entry : std::filesystem::directory_iterator("core/scene")) {
    const std::string name = entry.path().filename().string();
    const bool reads = name.starts_with("read_") || name.starts_with("scene_") || name == "form_properties.cpp";
    if (!reads) continue;
    const std::string text = read_whole_file(entry.path().string());
    const std::regex word("\"([a-z][a-z_]*)\"");
    for (std::sregex_iterator i(text.begin(), text.end(), word), end; i != end; ++i) words.insert((*i)[1]);
  }
  return words;
}

/// These are constructs with parts of their own on the page, or within others.
bool is_block(const std::string& key) {
  static const std::set<std::string> blocks{"sphere",   "light",    "camera",   "material",   "texture",
                                            "model",    "group",    "instance", "line",       "triangle",
                                            "polygon",  "plane",    "box",      "rectangle",  "union",
                                            "cylinder", "settings", "include",  "difference", "intersection"};
  return blocks.count(key) > 0;
}

TEST(Notation, ThePageHasWhatTheParserTakes) {
  const auto page = scene_notation().parts;
  std::set<std::string> surface;
  std::map<std::string, std::set<std::string>> listed;
  for (const NotationPart& part : page) {
    for (const NotationField& field : part.fields) {
      EXPECT_TRUE(listed[part.name].insert(field.key).second) << part.name << ": " << field.key << " twice";
      for (const std::string& cell : {field.value, field.standard, field.meaning}) EXPECT_FALSE(cell.empty());
      if (part.name == "material" && field.key != "name") surface.insert(field.key);
    }
  }
  const std::set<std::string> words = words_of_parser();
  ASSERT_GT(words.size(), 80u);
  std::size_t fields = 0;
  for (const NotationPart& part : page) {
    if (part.name == "settings" || part.name == "include") continue;
    ASSERT_EQ(places().count(part.name), 1u) << part.name << ": the test has no scene for it";
    std::set<std::string> own = listed[part.name];
    if (part.surface) own.insert(surface.begin(), surface.end());
    for (const std::string& key : own) EXPECT_TRUE(is_known(part.name, key)) << part.name << " has no " << key;
    for (const std::string& word : words) {
      // A vertex list of another dimension is another construct.
      if (is_block(word) || (word == "vertices" && places().at(part.name).find("vertices = ((") != std::string::npos))
        continue;
      if (part.name == "triangle of a model" && word == "vertices") continue;
      EXPECT_EQ(is_known(part.name, word), own.count(word) > 0)
          << part.name << ": " << word << (own.count(word) > 0 ? " is not known" : " is not on the page");
    }
    fields += own.size();
  }
  EXPECT_GT(fields, 150u);
  std::set<std::string> names;
  for (const NotationPart& part : page) names.insert(part.name);
  for (const std::string& word : words) {
    const bool has_part = is_block(word) && word != "union" && word != "intersection";
    EXPECT_TRUE(!has_part || names.count(word) == 1) << word;
  }
}

TEST(Notation, EveryExampleGivesItsPicture) {
  std::size_t compared = 0;
  for (const NotationPart& part : scene_notation().parts) {
    SCOPED_TRACE(part.name);
    ASSERT_FALSE(part.example.empty());
    ASSERT_FALSE(part.text.empty());
    const Scene scene = parse_scene(part.example, "example.scene", "assets/scenes");
    const Settings settings = settings_for(scene);
    const Image<Rgb8> drawn = display_frame(render(scene, {scene.camera, 160, 120}, settings), settings);
    EXPECT_EQ(drawn, load_levels(part.picture)) << "draw it again: assets/scenes/notation/make";
    std::set<std::array<int, 3>> colours;
    for (const Rgb8& level : drawn.pixels()) colours.insert({level.r, level.g, level.b});
    EXPECT_GT(colours.size(), 1u) << "nothing is seen";
    ++compared;
  }
  EXPECT_EQ(compared, places().size() + 2);
}

TEST(Notation, ThePageBeginsWithUnitsAndFormsOfValues) {
  const Notation page =
      parse_notation("# Title\n\nWhat it is.\n\nLengths in\nmetres.\n\n## light\nA lamp.\n", "page.md");
  EXPECT_EQ(page.text, "Lengths in metres.");
  ASSERT_EQ(page.parts.size(), 1u);
  EXPECT_EQ(page.parts[0].text, "A lamp.");
  EXPECT_NE(scene_notation().text.find("Lengths are in world units, angles in degrees."), std::string::npos);
}

TEST(Notation, ARowOfAnotherFormIsRefused) {
  EXPECT_EQ(test::refusal_of([] { parse_notation("## light\n| a | b |\n|---|---|\n| `x` | 1 |\n", "page.md"); }),
            "page.md:4: found a row of 2 cells, expected field, value, default and what it is");
}

}  // namespace
}  // namespace ps::notation_test
