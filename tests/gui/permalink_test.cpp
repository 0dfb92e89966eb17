// Everything on the screen as a line of text, as a file, inside a saved picture, and as a command: each brings the same
// screen back.
#include <gtest/gtest.h>

#include <filesystem>

#include "base/atomic_file.h"
#include "document/permalink_file.h"
#include "gui/program.h"
#include "support/golden.h"

namespace {

using ps::test::play;
using ps::test::read_file;

/// Options on both sides, another camera and pixel, a selected event, the tab of both stories, another tab below.
constexpr const char* arrange = R"(wait idle
set reflection-depth=1
set-b shading=flat
key Ctrl+Left
click-pixel B 210,420
wait idle
choose pixel/side both
choose bottom timings
key .
key .
wait idle
expect selected-event > 0
expect picked B
)";

/// What must be the same again.
std::string expectations(const std::string& link) {
  return "wait idle\nexpect permalink \"" + link + "\"\nexpect picked B\nexpect selected-event > 0\n" +
         "expect pixel/side both\nexpect bottom/timings on\n";
}

TEST(Permalink, FourWaysBringTheSameScreenBack) {
  const auto folder = ps::fresh_output_folder("gui-permalink");
  const std::string screen = std::filesystem::absolute(folder / "screen.permalink").string();
  const std::string picture = std::filesystem::absolute(folder / "picture.png").string();
  const std::string saving = std::string(arrange) + "keep permalink LINK\nprint permalink\n" +
                             "key P\nwait frames 3\ntype " + picture + "\nkey Enter\nwait idle\n" +
                             "key Ctrl+Shift+S\nwait frames 3\ntype " + screen + "\nkey Enter\nwait idle\n" +
                             "expect permalink $LINK\nscreenshot " + (folder / "before.png").string() + "\n" +
                             "key Shift+C\nwait frames 2\nprint clipboard\nquit\n";
  const auto saved = play(saving, folder, "1280x800", "cgfs/reflections");
  ASSERT_EQ(saved.status, 0) << saved.errors << saved.output;
  const auto end = saved.output.find('\n');
  std::string link = saved.output.substr(0, end);
  if (const auto equals = link.find("scene="); equals != std::string::npos) link = link.substr(equals);
  ASSERT_NE(link.find("event="), std::string::npos) << link;

  EXPECT_EQ(ps::permalink_in_file(screen), link);
  const std::string in_picture = ps::permalink_in_file(folder / "picture-a.png").value_or("");
  EXPECT_EQ(in_picture, link);

  const std::string same = expectations(link);
  const auto by_text = play(same, folder, "1280x800", "--permalink '" + link + "'");
  EXPECT_EQ(by_text.status, 0) << by_text.errors;
  const auto by_file = play(same, folder, "1280x800", "'" + screen + "'");
  EXPECT_EQ(by_file.status, 0) << by_file.errors;
  const auto by_picture = play(same, folder, "1280x800", "'" + (folder / "picture-a.png").string() + "'");
  EXPECT_EQ(by_picture.status, 0) << by_picture.errors;

  // The command that the window puts on the clipboard, as a shell reads it.
  std::string command = saved.output.substr(end + 1);
  const auto begins = command.find("pixelscope --permalink");
  ASSERT_NE(begins, std::string::npos) << saved.output;
  command = command.substr(begins + std::string("pixelscope ").size());
  command = command.substr(0, command.find('\n'));
  const auto by_command = play(same, folder, "1280x800", command);
  EXPECT_EQ(by_command.status, 0) << by_command.errors;

  // And in a window that shows something else.
  const auto opened = play("wait idle\nopen " + screen + "\nwait idle\n" + same, folder, "1280x800", "cgfs/crates");
  EXPECT_EQ(opened.status, 0) << opened.errors;
}

}  // namespace
