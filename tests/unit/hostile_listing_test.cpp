// Listings that mean harm: what they read while they are compiled, what they print, and what they do to their launcher.
// Where neither bubblewrap nor another user's rights can be had, the tests of what is shut off are skipped.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "base/foreign_text.h"
#include "student/check_listing.h"
#include "support/own_listings.h"

namespace ps::hostile_listing_test {
namespace {
using test::OwnListings;
using test::ScratchFolder;

bool root() { return geteuid() == 0; }

/// A listing whose routine has this body.
std::string listing_of(const std::string& before, const std::string& body) {
  return "#include <sys/types.h>\n#include <sys/socket.h>\n#include <sys/stat.h>\n#include <signal.h>\n"
         "#include <unistd.h>\n#include <cstdio>\n#include \"textbook/listing.h\"\n" +
         before + "\nnamespace ps {\nvoid draw_listing(const BookScene&, BookCanvas& canvas) {\n" + body +
         "\ncanvas.put_pixel(0, 0, Vec3d(1, 2, 3));\n}\n}\n";
}

/// One run of it, and what is left in the system's temporary folder under our name.
OwnRun run(const Compilation& compiled, Isolation isolation) {
  if (!compiled.program) throw InputError(compiled.messages.empty() ? compiled.failure : compiled.messages[0].text);
  const Scene scene;
  const View view{.camera = {}, .width = 4, .height = 4};
  RunOptions options{.limits = {}, .isolation = isolation};
  options.limits.seconds = 20;
  return run_listing(*compiled.program, book_scene(scene, view, Settings{}), {.picture = true, .traced = {}}, options);
}

/// The assembler's .incbin is no #include and leaves no trace in the messages.
TEST(HostileListing, TheCompilerReadsNoFileOfAnother) {
  if (!root() && !bubblewrap_works()) GTEST_SKIP() << "needs bubblewrap or root";
  const ScratchFolder home;
  const std::string secret = home.write("secret", "the-secret-words");
  std::filesystem::permissions(secret, std::filesystem::perms::owner_read);
  if (root()) std::filesystem::permissions(home.path(), std::filesystem::perms::owner_all);
  for (const Isolation isolation : {Isolation::bubblewrap_if_installed, Isolation::limits_only}) {
    if (isolation == Isolation::limits_only && !root()) continue;
    OwnListings own;
    const Compilation by_assembler = own.compile(
        listing_of("asm(\".section .rodata\\nb0: .incbin \\\"" + secret + "\\\"\\n.byte 0\\n.text\\n\");", ""),
        {.limits = {}, .search_path = {}, .isolation = isolation});
    EXPECT_FALSE(by_assembler.program);
    const Compilation by_include = own.compile(listing_of("#include \"" + secret + "\"", ""),
                                               {.limits = {}, .search_path = {}, .isolation = isolation});
    EXPECT_FALSE(by_include.program);
    for (const CompilerMessage& message : by_include.messages)
      EXPECT_EQ(message.text.find("the-secret-words"), std::string::npos) << message.text;
  }
}

TEST(HostileListing, TheCompilersMessagesHaveNoControlCharacters) {
  OwnListings own;
  const Compilation compiled =
      own.compile("#warning \x1b[31m red \x1b]0;title\x07\nstatic_assert(sizeof(int) == 5, \"\xc2\x9b"
                  "2J \xe2\x80\xae evil\");\n");
  ASSERT_GE(compiled.messages.size(), 2u);
  for (const CompilerMessage& message : compiled.messages) {
    EXPECT_EQ(message.text, foreign_text(message.text));
    EXPECT_EQ(message.text.find('\x1b'), std::string::npos);
  }
}

TEST(HostileListing, NoFileNoNetworkNoOtherProcessInBubblewrap) {
  if (!bubblewrap_works()) GTEST_SKIP() << "bubblewrap does not work here";
  const ScratchFolder home;
  const std::string secret = home.write("secret", "words");
  std::filesystem::permissions(home.path(), std::filesystem::perms::all);
  OwnListings own;
  const OwnRun done = run(own.compile(listing_of("", "std::puts(fopen(\"" + secret +
                                                         "\", \"r\") ? \"file\" : \"no file\");\n"
                                                         "std::puts(fopen(\"" +
                                                         home.path().string() +
                                                         "/new\", \"w\") ? \"wrote\" : \"not written\");\n"
                                                         "std::puts(kill(" +
                                                         std::to_string(getpid()) +
                                                         ", 0) == 0 ? \"process\" : \"no process\");\n"
                                                         "FILE* net = fopen(\"/proc/net/dev\", \"r\"); char line[200]; "
                                                         "int devices = -2;\n"
                                                         "while (net && fgets(line, 200, net)) ++devices;\n"
                                                         "std::printf(\"%d devices\\n\", devices);\n")),
                          Isolation::bubblewrap_if_installed);
  ASSERT_EQ(done.failure, "");
  EXPECT_EQ(done.text, "no file\nnot written\nno process\n1 devices\n");  // the loopback device
  EXPECT_FALSE(std::filesystem::exists(home.path() / "new"));
}

/// What it writes to a terminal is readable text; a folder that it closed to all is removed all the same.
TEST(HostileListing, TextIsCleanedAndNoFolderStays) {
  const ScratchFolder temporary;
  std::filesystem::permissions(temporary.path(), std::filesystem::perms::all);
  const test::Variable place("TMPDIR", temporary.path().string());
  {
    OwnListings own;
    const Compilation compiled =
        own.compile(listing_of("", "mkdir(\"inner\", 0700); chmod(\"inner\", 0); chmod(\".\", 0);\n"
                                   "std::puts(\"\\x1b[2Jcleared \\xc2\\x9b \\xe2\\x80\\xae \\xff caf\\xc3\\xa9\");"));
    const OwnRun done = run(compiled, Isolation::limits_only);
    EXPECT_EQ(done.failure, "");
    EXPECT_EQ(done.text, "?[2Jcleared ? ? ? caf\xc3\xa9\n");
  }
  for (const auto& left : std::filesystem::directory_iterator(temporary.path()))
    EXPECT_EQ(left.path().filename().string().find("pixelscope-"), std::string::npos) << left.path();
}

TEST(ForeignText, ReadableCharactersStay) {
  // Printable ASCII, line feed and tab; then the first and last characters of two, three and four bytes.
  std::string all = "\n\t";
  for (char c = ' '; c < 0x7F; ++c) all += c;
  all += "\xc2\xa0\xdf\xbf\xe0\xa0\x80\xef\xbf\xbd\xf0\x90\x80\x80\xf4\x8f\xbf\xbf";
  EXPECT_EQ(foreign_text(all), all);
}

TEST(ForeignText, WhatATerminalWouldObeyBecomesAQuestionMark) {
  EXPECT_EQ(foreign_text(std::string("\0\x01\x1b\r\x7f", 5)), "?????");
  EXPECT_EQ(foreign_text("\xc2\x80\xc2\x9b\xc2\x9f"), "???");                                                 // C1
  EXPECT_EQ(foreign_text("\xe2\x80\x8f\xe2\x80\xaa\xe2\x80\xae\xe2\x81\xa6\xe2\x81\xa9\xd8\x9c"), "??????");  // bidi
  EXPECT_EQ(foreign_text("\x80\xbf\xff\xc1\x81\xc3"), "??????");  // no characters
  EXPECT_EQ(foreign_text("\xe0\x80\x80\xed\xa0\x80\xf4\x90\x80\x80"),
            std::string(10, '?'));  // overlong, surrogate, too far
}

}  // namespace
}  // namespace ps::hostile_listing_test
