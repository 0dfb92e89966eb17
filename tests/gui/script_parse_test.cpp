#include <gtest/gtest.h>

#include "base/check.h"
#include "gui/script/expectation.h"
#include "gui/script/script.h"

namespace script_parse_test {
namespace {

using namespace ps::gui;

void expect_error(const std::string& text, int line, int column, const std::string& words) {
  try {
    parse_script(text, "s");
    ADD_FAILURE() << "accepted: " << text;
  } catch (const ps::InputError& error) {
    EXPECT_EQ(error.place().line, line) << text;
    EXPECT_EQ(error.place().column, column) << text;
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(ScriptParse, WordsQuotesAndComments) {
  const auto commands =
      parse_script("# a comment\n\n  click \"a b\" right # more\ntype \"say \\\"x\\\"\\n\"\r\nquit", "s");
  ASSERT_EQ(commands.size(), 3u);
  EXPECT_EQ(commands[0].verb, Verb::click);
  EXPECT_EQ(commands[0].words, (std::vector<std::string>{"a b", "right"}));
  EXPECT_EQ(commands[0].place.line, 3);
  EXPECT_EQ(commands[1].words[0], "say \"x\"\n");
  EXPECT_EQ(commands[2].verb, Verb::quit);
}

TEST(ScriptParse, ErrorsNameThePlace) {
  expect_error("wait idle\n  jump high\n", 2, 3, "'jump'");
  expect_error("type \"open\nquit\n", 1, 6, "quotation mark");
  expect_error("quit now", 1, 6, "quit");
  expect_error("click", 1, 1, "click CONTROL");
  expect_error("wait soon", 1, 6, "a number");
  expect_error("wait frames", 1, 6, "wait frames");
  expect_error("click x hard", 1, 7, "'hard'");
  expect_error("click-pixel C 1,2", 1, 13, "'C'");
  expect_error("click-pixel A 12", 1, 13, "two numbers");
  expect_error("key Hyper+X", 1, 5, "'Hyper+X'");
  expect_error("draw never", 1, 6, "draw on or draw off");
  expect_error("draw", 1, 1, "draw on or draw off");
  expect_error("resize 100", 1, 8, "two numbers");
  expect_error("expect a !! b", 1, 8, "'!!'");
  expect_error("set gamma", 1, 5, "'gamma'");
  expect_error("clock soon", 1, 7, "a number");
  expect_error("wheel nan", 1, 7, "a number");
  expect_error("quit\nwheel 1e300", 2, 7, "a number from -1000 to 1000");
  expect_error("wait 1e300", 1, 6, "a number from 0 to 3600000");
  expect_error("wait -1", 1, 6, "a number from 0");
  expect_error("wait frames 1e300", 1, 6, "a number from 0 to 100000");
  expect_error("click-pixel A 1e300,1e300", 1, 13, "a number from 0 to 65535");
  expect_error("resize 1e9x1e9", 1, 8, "a number from 1 to 16384");
  expect_error("resize 0x700", 1, 8, "a number from 1 to 16384");
  expect_error("drag x 1e300,0", 1, 6, "a number from -100000 to 100000");
}

TEST(Expectation, ComparesNumbersAsNumbersAndTextAsText) {
  EXPECT_TRUE(fulfils("0.50", {.value = "0.5"}));
  EXPECT_FALSE(fulfils("0.5", {.value = "0.51"}));
  EXPECT_TRUE(fulfils("phong", {.value = "phong"}));
  EXPECT_TRUE(fulfils("phong", {.relation = "!=", .value = "flat"}));
  EXPECT_TRUE(fulfils("100.4", {.relation = "~=", .value = "100", .tolerance = 0.005}));
  EXPECT_FALSE(fulfils("100.6", {.relation = "~=", .value = "100", .tolerance = 0.005}));
  EXPECT_FALSE(fulfils("many", {.relation = ">", .value = "3"}));
  EXPECT_TRUE(fulfils("4", {.relation = ">", .value = "3"}));
  EXPECT_TRUE(fulfils("a red sphere", {.relation = "contains", .value = "red"}));
}

}  // namespace
}  // namespace script_parse_test
