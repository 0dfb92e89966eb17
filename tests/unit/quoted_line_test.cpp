// The line of a file that a message is about, with a caret below its column.
#include "base/quoted_line.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "base/input_errors.h"
#include "support/run_cli.h"

namespace ps::quoted_line_test {
namespace {

TEST(QuotedLine, HasACaretUnderTheColumn) {
  const test::ScratchFolder folder;
  const std::string file = folder.write("a.scene", "sphere {\n\tradius = -1\n  name = größe = 2\r\n}\n");
  EXPECT_EQ(quoted_line({file, 2, 11}), "\n     radius = -1\n              ^");
  EXPECT_EQ(quoted_line({file, 1, 1}), "\n    sphere {\n    ^");
  // Columns count characters, of one byte or two.
  EXPECT_EQ(quoted_line({file, 3, 18}), "\n      name = größe = 2\n                     ^");
  // The end of the line is a place, too.
  EXPECT_EQ(quoted_line({file, 4, 2}), "\n    }\n     ^");
}

TEST(QuotedLine, OfALongLineThePartAroundTheColumn) {
  const test::ScratchFolder folder;
  for (const int before : {0, 5, 500, 995, 1000}) {
    const std::string line = std::string(static_cast<std::size_t>(before), 'a') + "X" + std::string(500, 'b');
    const std::string quoted = quoted_line({folder.write("long.scene", line + "\n"), 1, before + 1});
    const auto caret = quoted.find('^') - quoted.rfind('\n') - 1;
    EXPECT_EQ(quoted.at(1 + caret), 'X') << before;
    EXPECT_EQ(quoted.find('\n', 1), 1u + 4 + 72) << before;
  }
}

TEST(QuotedLine, WhatIsNotTextIsMarked) {
  const test::ScratchFolder folder;
  const std::string file = folder.write("a.scene", "a\x1b[31m\xff b\n");
  EXPECT_EQ(quoted_line({file, 1, 9}), "\n    a?[31m? b\n            ^");
}

TEST(QuotedLine, IsEmptyWithoutAPlace) {
  const test::ScratchFolder folder;
  const std::string file = folder.write("a.scene", "x\n");
  EXPECT_EQ(quoted_line({file, 0, 0}), "");
  EXPECT_EQ(quoted_line({file, 1, 0}), "");
  EXPECT_EQ(quoted_line({file, 3, 1}), "");
  EXPECT_EQ(quoted_line({folder.file("none"), 1, 1}), "");
  EXPECT_EQ(quoted_line({"/dev/zero", 1, 1}), "");
}

TEST(QuotedLine, OfSeveralErrorsEach) {
  const test::ScratchFolder folder;
  const std::string file = folder.write("a.scene", "one\ntwo\n");
  const InputError first({file, 1, 1}, "one", "1"), second({file, 2, 3}, "two", "2");
  const InputErrors both({first, second});
  EXPECT_STREQ(both.what(), first.what());
  EXPECT_EQ(quoted_lines(both), "\n    one\n    ^\n" + file + ":2:3: found two, expected 2\n    two\n      ^");
  EXPECT_EQ(quoted_lines(first), "\n    one\n    ^");
  EXPECT_EQ(quoted_lines(std::runtime_error("other")), "");
}

}  // namespace
}  // namespace ps::quoted_line_test
