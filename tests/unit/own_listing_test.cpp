// A student's own listing: copies, which file may be compiled, what the compiler says, and what may go wrong when it
// runs.
#include "student/own_listing.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/read_file.h"
#include "engine/lesson.h"
#include "student/check_listing.h"
#include "student/last_words.h"
#include "support/own_listings.h"
#include "support/refusal.h"
#include "support/run_cli.h"

namespace ps::own_listing_test {
namespace {
using test::listing_in;
using test::OwnListings;
using test::with_change;

const std::string spheres = "cgfs_02_basic_ray_tracing";

TEST(OwnListing, ACopyNeverTakesTheNameOfAnother) {
  OwnListings own;
  const auto first = own.permits().copy(listing_in(spheres));
  EXPECT_EQ(first.file(), own.folder().path() / "pixelscope" / "listings" / (spheres + ".cpp"));
  own.folder().write("pixelscope/listings/" + spheres + ".cpp", "changed");
  const auto second = own.permits().copy(listing_in(spheres));
  EXPECT_EQ(second.file().filename(), spheres + "_2.cpp");
  EXPECT_EQ(read_whole_file(first.file()), "changed");
}

// A limit on the size of files fails in the middle of the text, as a full disk does.
TEST(OwnListing, ACopyThatDoesNotFitLeavesNothing) {
  const test::ScratchFolder folder;
  const std::string command = "trap '' XFSZ; ulimit -f 1; XDG_DATA_HOME=" + folder.path().string() +
                              " exec " PIXELSCOPE_BIN_DIR "/pixelscope-cli listing copy " + spheres +
                              " >/dev/null 2>&1";
  const int ended = std::system(("bash -c \"" + command + "\"").c_str());
  EXPECT_EQ(WEXITSTATUS(ended), 2);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path() / "pixelscope" / "listings"));
}

TEST(OwnListing, ItIncludesOneHeaderOfOurs) {
  for (const NamedListing& listing : listings()) {
    const std::string copy = listing_copy(listing);
    const std::size_t ours = copy.find("#include \"");
    EXPECT_EQ(copy.substr(ours, 30), "#include \"textbook/listing.h\"\n");
    EXPECT_EQ(copy.find("#include \"", ours + 1), std::string::npos);
    EXPECT_EQ(copied_listing(copy), &listing);
  }
}

TEST(OwnListing, OnlyWhatAPersonMadeOrChoseIsAllowed) {
  OwnListings own;
  const std::string outside = own.folder().write("outside.cpp", "int x;\n");
  EXPECT_FALSE(own.permits().find(outside));
  const auto made = own.permits().copy(listing_in(spheres));
  EXPECT_TRUE(own.permits().find(made.file()));
  EXPECT_FALSE(own.permits().find(outside)) << "one file does not allow another";
  EXPECT_FALSE(ListingPermits().find(made.file())) << "nor does an earlier run of the program, by the folder";
  std::filesystem::create_symlink(outside, own.folder().path() / "pixelscope" / "listings" / "link.cpp");
  EXPECT_FALSE(own.permits().find(own.folder().path() / "pixelscope" / "listings" / "link.cpp"));
  own.permits().permit(outside);
  EXPECT_TRUE(own.permits().find(outside));
  EXPECT_THROW(own.permits().permit(own.folder().path()), InputError);
}

TEST(OwnListing, RoutinesAreFoundAndLeftToBeWritten) {
  const NamedListing& listing = listing_in(spheres);
  const std::vector<std::string> all{"canvas_to_viewport", "intersect_ray_sphere", "trace_ray", "draw"};
  EXPECT_EQ(listing_routines(listing_copy(listing)), all);
  const std::string copy = listing_copy(listing, "intersect_ray_sphere");
  EXPECT_EQ(copy.find("discriminant < 0"), std::string::npos);
  EXPECT_NE(copy.find("  // TODO: write this routine.\n  return {};\n}\n"), std::string::npos);
  EXPECT_EQ(listing_routines(copy), all);
  EXPECT_NE(test::refusal_of([&] { listing_copy(listing, "nonsense"); }).find("intersect_ray_sphere"),
            std::string::npos);
}

TEST(OwnListing, ErrorsAreAtTheirLines) {
  OwnListings own;
  const std::string copy = listing_copy(listing_in(spheres));
  const std::string line = "  const double discriminant = b * b - 4 * a * c;\n";
  const auto number = 1 + std::count(copy.begin(), copy.begin() + static_cast<long>(copy.find(line)), '\n');
  const Compilation compiled =
      own.compile(with_change(copy, line, "  const double discriminant = b * b - 4 * a * q;\n"));
  EXPECT_FALSE(compiled.program);
  EXPECT_EQ(compiled.failure, "It does not compile.");
  ASSERT_FALSE(compiled.messages.empty());
  EXPECT_EQ(compiled.messages[0].line, number);
  EXPECT_EQ(compiled.messages[0].kind, MessageKind::error);
  EXPECT_NE(compiled.messages[0].text.find('q'), std::string::npos);
}

TEST(OwnListing, WhatBothCompilersAndLinkersSayIsRead) {
  const auto messages = compiler_messages(
      "In file included from listing.cpp:3:\n/x/y.h:1:2: error: in a header\nlisting.cpp:7:12: warning: w\n"
      "listing.cpp:9: error: no column\n/usr/bin/ld: a.o: in function `main':\nm.cpp:(.text+0x1): undefined reference "
      "to "
      "`ps::draw_listing(ps::BookScene const&, ps::BookCanvas&)'\ncollect2: error: ld returned 1 exit status\n");
  ASSERT_EQ(messages.size(), 4u);
  EXPECT_EQ(messages[0].line, 0);
  EXPECT_EQ(messages[0].text, "/x/y.h:1:2: error: in a header");
  EXPECT_EQ(messages[1].line, 7);
  EXPECT_EQ(messages[1].column, 12);
  EXPECT_EQ(messages[1].kind, MessageKind::warning);
  EXPECT_EQ(messages[2].line, 9);
  EXPECT_EQ(messages[3].text.substr(0, 21), "There is no routine v");
}

TEST(OwnListing, WhatAssemblerAndLinkerSayIsShown) {
  OwnListings own;
  const auto said = [&](const std::string& source) {
    const Compilation compiled = own.compile(source);
    EXPECT_FALSE(compiled.program);
    return compiled.messages.empty() ? compiled.failure : compiled.messages[0].text;
  };
  EXPECT_EQ(said("asm(\"jabberwock bar\");").substr(0, 11), "assembler: ");
  EXPECT_NE(said("asm(\"jabberwock bar\");").find("jabberwock"), std::string::npos);
  EXPECT_EQ(said(listing_copy(listing_in(spheres)) + "int main() {}\n"), "multiple definition of `main'");
}

// Neither g++ nor its parts have a word beside the file's name where memory ends: the line that says so is not the
// first.
TEST(OwnListing, ACompilerThatDiesLeavesTheLineThatSaysWhy) {
  EXPECT_EQ(last_words("\ncc1plus: out of memory allocating 65536 bytes after a total of 88 bytes\n"),
            "cc1plus: out of memory allocating 65536 bytes after a total of 88 bytes");
  EXPECT_EQ(last_words("In file included from listing.cpp:1:\ng++: cannot execute 'cc1plus': Permission denied\n"
                       "compilation terminated.\n"),
            "g++: cannot execute 'cc1plus': Permission denied");
  EXPECT_EQ(last_words("bwrap: execvp /tmp/p: Permission denied"), "bwrap: execvp /tmp/p: Permission denied");
  EXPECT_EQ(last_words("collect2: error: ld returned 1 exit status\n \n"),
            "collect2: error: ld returned 1 exit status");
  EXPECT_EQ(last_words("\n \n"), "");
  OwnListings own;
  const Compilation compiled = own.compile("asm(\".rept 1000000000\\n.quad 1\\n.endr\");");
  EXPECT_FALSE(compiled.program);
  EXPECT_NE(compiled.failure, "The compiler failed: ");
  EXPECT_FALSE(compiled.failure.empty());
}

TEST(OwnListing, WithoutACompilerItSaysSo) {
  OwnListings own;
  const Compilation compiled = own.compile("", {.limits = {}, .search_path = own.folder().path().string()});
  EXPECT_FALSE(compiled.program);
  EXPECT_NE(compiled.failure.find("No C++ compiler was found"), std::string::npos);
}

/// 2^40 instances of a template.
TEST(OwnListing, AnEndlessCompilationIsStopped) {
  OwnListings own;
  CompileOptions options;
  options.limits.seconds = 1;
  const Compilation compiled = own.compile(
      "template <int N, long M> struct A { static constexpr long v = A<N - 1, 2 * M>::v + A<N - 1, 2 * M + 1>::v; };\n"
      "template <long M> struct A<0, M> { static constexpr long v = M; };\nlong x = A<40, 0>::v;\n",
      options);
  EXPECT_FALSE(compiled.program);
  EXPECT_EQ(compiled.failure, "The compiler did not end within 1 s and was stopped.");
  EXPECT_LT(compiled.seconds, 10);
}

/// One program for all that may go wrong: the number of reflections chooses.
class OwnListingRuns : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    OwnListings own;
    compiled_ = new Compilation(own.compile(R"(
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <unistd.h>
#include "textbook/listing.h"
namespace ps {
void draw_listing(const BookScene& scene, BookCanvas& canvas) {
  volatile int* nowhere = nullptr;
  switch (scene.settings.reflection_depth) {
  case 1: for (volatile long i = 0;; i = i + 1) {}
  case 2: *nowhere = 1; break;
  case 3: for (;;) fork();
  case 4: for (const std::string line(1000, 'x');;) std::puts(line.c_str());
  case 5: throw std::out_of_range("index 7 of 3");
  case 6: std::exit(0);
  case 7: if (write(3, "nonsense", 8) < 8) return; std::_Exit(0);
  case 8: std::raise(SIGFPE); break;
  case 9: for (std::vector<std::string> all;;) all.emplace_back().reserve(1 << 24);  // untouched: no processor time
  case 10: std::this_thread::sleep_for(std::chrono::hours(1)); break;
  case 11: if (fork() == 0) { setsid(); sleep(60); } break;
  case 12: std::puts(std::getenv("HOME") == nullptr ? "no home" : "home"); break;
  default: break;
  }
  canvas.put_pixel(0, 0, Vec3d(1, 2, 3));
  PS_WATCH("name", 5);
}
}
)"));
  }
  static void TearDownTestSuite() {
    delete compiled_;
    compiled_ = nullptr;
  }
  /// `seconds`: enough for a second of processor time on a machine that has much else to do.
  static OwnRun run(int what, double seconds = 120, Isolation isolation = Isolation::limits_only) {
    if (!compiled_->program)
      throw InputError(compiled_->messages.empty() ? compiled_->failure : compiled_->messages[0].text);
    const Scene scene;
    Settings settings;
    settings.reflection_depth = what;
    const View view{.camera = {}, .width = 20, .height = 10};
    RunOptions options{.limits = {}, .isolation = isolation};
    options.limits.processor_seconds = 1;
    options.limits.seconds = seconds;
    return run_listing(*compiled_->program, book_scene(scene, view, settings),
                       {.picture = true, .traced = Vec2i{10, 4}}, options);
  }
  static Compilation* compiled_;
};
Compilation* OwnListingRuns::compiled_ = nullptr;

TEST_F(OwnListingRuns, WhatGoesWrongIsASentence) {
  EXPECT_EQ(
      run(1).failure,
      "It used more than 1 s of processor time and was stopped. Does a loop never end? If all of them do, choose a "
      "smaller picture size or a scene with fewer triangles.");
  EXPECT_NE(run(2).failure.find("SIGSEGV"), std::string::npos);
  EXPECT_EQ(run(5).failure, "It threw an exception: index 7 of 3");
  EXPECT_EQ(run(6).failure, "It ended before its picture was complete.");
  EXPECT_NE(run(7).failure.find("What it wrote is not its picture"), std::string::npos);
  EXPECT_NE(run(8).failure.find("divided a whole number by zero"), std::string::npos);
  EXPECT_EQ(run(9).failure, "It asked for more than 1 GB of memory.");
  EXPECT_EQ(run(10, 0.5).failure, "It did not end within 0.5 s and was stopped.");
}

TEST_F(OwnListingRuns, AForkBombAndAGigabyteOfOutputEnd) {
  const std::string bomb = run(3, 2).failure;
  EXPECT_TRUE(bomb == "It started more than 64 processes and was stopped." ||
              bomb.find("processor time") != bomb.npos || bomb.find("did not end") != bomb.npos)
      << bomb;
  const OwnRun output = run(4);
  EXPECT_EQ(output.failure, "It printed more than 16 MB and was stopped.");
  EXPECT_LE(output.text.size(), 64u << 10);
}

TEST_F(OwnListingRuns, AnOrphanDoesNotKeepThePictureWaiting) {
  const OwnRun done = run(11);
  EXPECT_EQ(done.failure, "");
  EXPECT_LT(done.seconds, 30) << "it sleeps for a minute";
}

TEST_F(OwnListingRuns, PictureAndValuesComeBackFromBubblewrapToo) {
  for (const Isolation isolation : {Isolation::limits_only, Isolation::bubblewrap_if_installed}) {
    const OwnRun done = run(12, 120, isolation);
    ASSERT_EQ(done.failure, "");
    EXPECT_EQ(done.text, "no home\nno home\n");  // for the picture and for the values
    EXPECT_EQ(done.result.picture.at(10, 4), Vec3d(1, 2, 3));
    EXPECT_EQ(done.result.picture.at(0, 0), Vec3d(255));
    ASSERT_EQ(done.result.trace->watches.size(), 1u);
    EXPECT_EQ(done.result.trace->watches[0].name, "name");
    EXPECT_EQ(done.result.trace->watches[0].value, WatchValue(std::int64_t{5}));
    EXPECT_NE(run(2, 120, isolation).failure.find("SIGSEGV"), std::string::npos);
  }
}

}  // namespace
}  // namespace ps::own_listing_test
