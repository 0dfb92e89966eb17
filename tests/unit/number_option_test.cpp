// Numbers on the command line: only finite decimal ones inside their range are taken.
#include <gtest/gtest.h>

#include <algorithm>
#include <new>
#include <stdexcept>
#include <system_error>

#include "base/failure_text.h"
#include "base/spelling.h"
#include "support/run_cli.h"
#include "support/trials.h"

namespace ps::number_option_test {
namespace {

using test::run_cli;

TEST(NumberOptions, OnlyFiniteNumbersInsideTheRange) {
  const test::ScratchFolder folder;
  struct Row {
    std::vector<std::string> arguments;  // the last one is the option
    std::vector<std::string> wrong;
  };
  const std::vector<Row> rows{
      {{"needs", "cgfs/spheres", "--size", "4x4", "--tolerance"},
       {"nan", "NaN", "-nan", "inf", "-inf", "1e999", "1.1", "-0.1", "0x1"}},
      {{"stability", "epsilon-unit", "--effort"}, {"nan", "inf", "0", "11", "0.1x"}},
      {{"inspect", "cgfs/cubes", "--size", "4x4", "--pixel", "2,2", "--vertex", "nearest", "--vertex-near"},
       {"nan", "inf", "0", "-1", "1e309"}},
      {{"inspect", "cgfs/cubes", "--size", "4x4", "--pixel", "2,2", "--instance"},
       {"nan", "-1", "1e3", "010", "2147483648"}},
      {{"needs", "cgfs/spheres", "--size", "4x4", "--repeats"}, {"nan", "0", "1001", "010", "0x10", "1.5"}},
      {{"chart", "cgfs/spheres", "--out", folder.file("never"), "--reference-samples"}, {"nan", "0", "4097"}},
      {{"causes", "cgfs/spheres", "--set-b", "gamma=2", "--orders"}, {"nan", "0", "10001"}},
      {{"stability", "epsilon-unit", "--seed"}, {"nan", "-1", "4294967296"}},
      {{"render", "cgfs/spheres", "--out", folder.file("never.png"), "--region"}, {"nan,0,1,1", "0,0,1,0x1"}},
      {{"render", "cgfs/spheres", "--out", folder.file("never.png"), "--set"},
       {"gamma=nan", "gamma=inf", "gamma=1e999", "samples-per-pixel=nan"}},
      {{"render", "cgfs/spheres", "--out", folder.file("never.png"), "--camera"}, {"nan,0,0,1,0,0,0,1,0,0,0,1,1,1,1"}}};
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.wrong.size(); i += test::list_step) {
      const std::string& wrong = row.wrong[i];
      std::vector<std::string> arguments = row.arguments;
      arguments.back() += "=" + wrong;
      const auto result = run_cli(arguments);
      EXPECT_EQ(result.status, 2) << row.arguments.back() << " " << wrong;
      EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
      EXPECT_NE(result.err.find("expected"), std::string::npos) << result.err;
      EXPECT_LT(result.err.size(), 200u) << result.err;
      EXPECT_EQ(result.out, "");
    }
}

TEST(NumberOptions, TheEndsOfARangeAreAllowed) {
  EXPECT_EQ(run_cli({"needs", "cgfs/lines", "--size", "4x4", "--repeats", "1", "--tolerance", "1"}).status, 0);
  EXPECT_EQ(run_cli({"needs", "cgfs/lines", "--size", "4x4", "--repeats", "1", "--tolerance", "0"}).status, 0);
  const test::ScratchFolder folder;
  EXPECT_EQ(
      run_cli({"render", "cgfs/lines", "--size", "4x4", "--region", "-2,-2,4,4", "--out", folder.file("a.png")}).status,
      0);
}

TEST(NumberOptions, LongWordsAreCutInMessages) {
  const test::ScratchFolder folder;
  const std::string word(100'000, 'x');
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {word},
           {"options", "--" + word},
           {"render", "cgfs/spheres", "--out", folder.file("never.png"), "--set", word + "=1"},
           {"render", "cgfs/spheres", "--out", folder.file("never.png"), "--set", word},
           {"render", "cgfs/spheres", "--out", folder.file("never.png"), "--set", "gamma=" + word},
           {"needs", "cgfs/spheres", "--tolerance", word}}) {
    const auto result = run_cli(arguments);
    EXPECT_EQ(result.status, 2);
    EXPECT_LT(result.err.size(), 5000u);
  }
}

TEST(NumberOptions, ALongNameIsNotComparedAsAWhole) {
  // The nearest word depends on the first letters alone: what follows is not looked at, so it costs nothing.
  const std::vector<std::string_view> known{"gamma", "renderer"};
  const std::string start(64, 'g');
  EXPECT_EQ(nearest_word(start + std::string(1000, 'r'), known), nearest_word(start, known));
}

TEST(FailureText, SaysWhatRanOut) {
  EXPECT_NE(failure_text(std::bad_alloc()).find("not enough memory"), std::string::npos);
  const std::system_error no_thread(std::make_error_code(std::errc::resource_unavailable_try_again));
  EXPECT_NE(failure_text(no_thread).find("another thread"), std::string::npos);
  EXPECT_EQ(failure_text(std::system_error(std::make_error_code(std::errc::no_space_on_device))),
            "the system reports: No space left on device");
  EXPECT_EQ(failure_text(std::runtime_error("as it is")), "as it is");
}

}  // namespace
}  // namespace ps::number_option_test
