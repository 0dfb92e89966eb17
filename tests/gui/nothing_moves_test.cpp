// What is pressed most while one explores moves nothing: the areas of pictures, story, bar and drawer stay where they
// were, and the pictures' own where scene and comparison stay.
#include <gtest/gtest.h>

#include <array>

#include "document/technique.h"
#include "gui/program.h"
#include "support/golden.h"

namespace nothing_moves_test {
namespace {

constexpr std::array regions{"area/techniques", "area/pictures", "area/right", "area/bottom"};
constexpr std::array pictures{"area/a", "area/b"};

std::string word_of(const std::string& area) { return "AT" + area.substr(area.rfind('/') + 1); }

template <class Areas>
std::string kept(const Areas& areas) {
  std::string commands;
  for (const char* area : areas) commands += "keep " + std::string(area) + " " + word_of(area) + "\n";
  return commands;
}

template <class Areas>
std::string still_there(const Areas& areas) {
  std::string commands = "wait idle\nwait frames 2\n";
  for (const char* area : areas) commands += "expect " + std::string(area) + " \"$" + word_of(area) + "\"\n";
  return commands;
}

class NothingMoves : public testing::TestWithParam<const char*> {};

TEST_P(NothingMoves, OnClicksKeysAndTechniques) {
  std::string commands = "draw off\nwait idle\n" + kept(regions) + kept(pictures);
  for (const char* action :
       {"click-pixel A 150,200\n", "key Right\n", "key Down\n", "click pixel/pin\n", "click pixel/pin\n", "key N\n",
        "key Shift+N\n", "key G\n", "key G\n", "key T\n", "key T\n", "click-pixel B 100,100\n",
        "click pixel/side/parting\n", "click pixel/side/a\n", "click-pixel A 5,5\n"})
    commands += action + still_there(regions) + still_there(pictures);
  for (const ps::Technique& technique : ps::technique_table())
    for (const ps::TechniqueChoice& choice : technique.choices) {
      std::string name = "techniques/" + std::string(technique.key);
      if (technique.choices.size() > 1) name += "/" + std::string(choice.key);
      commands += "click " + name + "\n" + still_there(regions);
    }
  // The way back leads to the scene, and to the place of its pictures.
  commands +=
      "click techniques/back\n" + still_there(regions) + "expect scene cgfs/reflections\n" + still_there(pictures);
  const auto run = ps::test::play(commands, ps::fresh_output_folder(std::string("gui-nothing-moves-") + GetParam()),
                                  GetParam(), "--size 300x300");
  EXPECT_EQ(run.status, 0) << run.errors;
}

INSTANTIATE_TEST_SUITE_P(Sizes, NothingMoves, testing::Values("1024x768", "1366x768", "1920x1080"),
                         [](const auto& one) { return "at_" + std::string(one.param); });

}  // namespace
}  // namespace nothing_moves_test
