#include <gtest/gtest.h>

#include <ostream>
#include <vector>

#include "base/input_errors.h"
#include "obj_corpus.h"
#include "support/refusal.h"

namespace obj_errors_test {
namespace {

const std::string three_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

struct BadModel {
  const char* name;
  std::string text;
  int line, column;
  const char* found;
  const char* expected;
  friend std::ostream& operator<<(std::ostream& out, const BadModel& bad) { return out << bad.name; }
};

void expect_refused(const BadModel& bad) {
  const ps::test::ModelFolder folder;
  const ps::InputError expected({(folder.path() / "model.obj").string(), bad.line, bad.column}, bad.found,
                                bad.expected);
  EXPECT_EQ(ps::test::refusal_of([&] { folder.load(bad.text); }), expected.what());
}

class ObjErrorCorpus : public testing::TestWithParam<BadModel> {};

TEST_P(ObjErrorCorpus, NamePlaceFoundAndExpected) { expect_refused(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    All, ObjErrorCorpus,
    testing::Values(
        BadModel{"nan", "v nan 0 0\n", 1, 3, "'nan'", "a number"},
        BadModel{"inf", "v 0 0 -inf\n", 1, 7, "'-inf'", "a number"},
        BadModel{"banana", "v 1 banana 0\n", 1, 5, "'banana'", "a number"},
        BadModel{"decimal_comma", "v 1,5 0 0\n", 1, 3, "'1,5'", "a number"},
        BadModel{"hexadecimal", "v 0x10 0 0\n", 1, 3, "'0x10'", "a number"},
        BadModel{"overflow", "v 1e400 0 0\n", 1, 3, "'1e400'", "a number below 1e12"},
        BadModel{"underflow", "v 1e-400 0 0\n", 1, 3, "'1e-400'", "a number that is 0 or above 1e-300"},
        BadModel{"zero_with_huge_exponent", "v 0e99999 0 0\n", 1, 3, "'0e99999'", "a number below 1e12"},
        BadModel{"used_nan", three_vertices + "v 0 nan 0\nv 0 0 x\nf 1 2 3\nf 1 2 5\n", 5, 7, "'x'", "a number"},
        BadModel{"two_coordinates", "v 1 2\n", 1, 6, "the end of the line", "a number"},
        BadModel{"no_faces", "v 0 0 0\n\nv 1 0 0\n", 3, 0, "no face in 3 lines", "at least one line 'f 1 2 3'"},
        BadModel{"index_zero", three_vertices + "f 0 1 2\n", 4, 3, "'0'",
                 "an index from 1 up, or below 0 to count backwards"},
        BadModel{"index_too_large", three_vertices + "f 1 2 4\n", 4, 7, "index 4 in '4'",
                 "a vertex index of at most 3"},
        BadModel{"first_of_two_too_large", three_vertices + "f 1 2 3\nf 1 2 7\nf 9 2 3\n", 5, 7, "index 7 in '7'",
                 "a vertex index of at most 3"},
        BadModel{"negative_beyond_start", three_vertices + "f -1 -2 -4\n", 4, 9, "index -4 in '-4'",
                 "a vertex index of at least -3, counted back from this line"},
        BadModel{"index_2_31", three_vertices + "f 1 2 2147483648\n", 4, 7, "index 2147483648 in '2147483648'",
                 "a vertex index of at most 3"},
        BadModel{"index_2_63", three_vertices + "f 1 2 9223372036854775808\n", 4, 7,
                 "index 1000000000000 in '9223372036854775808'", "a vertex index of at most 3"},
        BadModel{"two_corners", three_vertices + "f 1 2\n", 4, 6, "a face with 2 vertices", "at least 3 vertices"},
        BadModel{"corner_of_words", three_vertices + "f a b c\n", 4, 3, "'a'",
                 "a vertex reference such as 1, 1/2, 1//3 or 1/2/3"},
        BadModel{"utf16", std::string("\xFF\xFEv\0 \0", 6), 1, 1, "UTF-16 text", "UTF-8 text"},
        BadModel{"nul", std::string("v 0 0 0\nv 1 \0 0\n", 16), 2, 0, "a NUL byte", "text"},
        BadModel{"unknown_statement", "v 0 0 0\nvx 1 2 3\n", 2, 1, "'vx'", "'v'"},
        BadModel{"nothing", "", 0, 0, "an empty file", "a scene or model"},
        BadModel{"carriage_returns_alone", "v 0 0 0\rv 1 x 0\r", 2, 5, "'x'", "a number"}),
    [](const auto& bad) { return std::string(bad.param.name); });

/// All at once, so that not each needs another try. Five are enough.
TEST(ObjErrors, SeveralLinesAreReportedTogether) {
  const ps::test::ModelFolder folder;
  const auto lines_of = [&](const std::string& text) {
    std::vector<int> lines;
    try {
      folder.load(text);
    } catch (const ps::InputErrors& errors) {
      for (const ps::InputError& error : errors.all()) lines.push_back(error.place().line);
    }
    return lines;
  };
  const std::string good = three_vertices + "f 1 2 3\n";
  EXPECT_EQ(lines_of(good), (std::vector<int>{}));
  EXPECT_EQ(lines_of(good + "f 1 2 0\nf 1 3 2\nf a b c\n"), (std::vector{5, 7}));                      // no references
  EXPECT_EQ(lines_of(good + "f 1 2 9\nf 1 3 2\nf 8 7 1\n"), (std::vector{5, 7}));                      // to no vertices
  EXPECT_EQ(lines_of("v x 0 0\nv 0 x 0\nv 1 0 0\nv y 0 0\nf 1 2 3\nf 1 3 2\n"), (std::vector{1, 2}));  // those in use
  EXPECT_EQ(lines_of(good + "f 0 0 0\nf 0 0 0\nf 0 0 0\nf 0 0 0\nf 0 0 0\nf 0 0 0\n"), (std::vector{5, 6, 7, 8, 9}));
}

// Not one of the corpus: whatever tests of this program run, each start would copy its text.
TEST(ObjErrors, ALineOfMillionsOfBytes) {
  expect_refused({"long_line", "v 0 0 0" + std::string(8'000'000, ' ') + "\n", 1, 1, "a line of 8000007 bytes",
                  "at most 4194304 bytes"});
}

}  // namespace
}  // namespace obj_errors_test
