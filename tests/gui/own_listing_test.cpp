// A student's own listing in the window: copied, saved with a change and with an error, and what stands then in B and
// beside the lines. The script's `write` is what the student's editor does.
#include <gtest/gtest.h>

#include <filesystem>

#include "gui/program.h"
#include "support/golden.h"
#include "support/own_listings.h"

namespace own_listing_window_test {
namespace {

using ps::test::with_change;

/// As a word of a script.
std::string quoted(const std::string& text) {
  std::string word = "\"";
  for (const char c : text) {
    if (c == '\n') {
      word += "\\n";
      continue;
    }
    if (c == '"' || c == '\\') word += '\\';
    word += c;
  }
  return word + "\"";
}

TEST(OwnListingWindow, ACopyIsCompiledOnSaveAndStandsAsB) {
  const auto folder = std::filesystem::absolute(ps::fresh_output_folder("gui-own-listing"));
  const ps::test::Variable data("XDG_DATA_HOME", (folder / "data").string());
  const ps::test::Variable cache("XDG_CACHE_HOME", (folder / "cache").string());
  const ps::NamedListing& listing = ps::test::listing_in("cgfs_02_basic_ray_tracing");
  const std::string copy = ps::listing_copy(listing);
  const std::string line = "  const double discriminant = b * b - 4 * a * c;\n";
  const auto number = 1 + std::count(copy.begin(), copy.begin() + static_cast<long>(copy.find(line)), '\n');
  const std::string file =
      (folder / "data/pixelscope/listings/cgfs_02_basic_ray_tracing_intersect_ray_sphere.cpp").string();
  const std::string write = "write " + file + " ";
  const std::string out = folder.string() + "/";
  std::string script = "wait idle\nexpect own/open off\nclick listing/copy\nwait idle\nexpect own/path " + file +
                       "\nexpect own/wrong > 1000\nscreenshot " + out + "task.png\n";
  script += write + quoted(copy) + "\nwait until own/saves 1\nwait idle\nexpect own/wrong 0\n" +
            "expect listing/own/state contains \"to the bit\"\nscreenshot " + out + "right.png\n";
  script += write + quoted(with_change(copy, "closest_sphere->colour;", "closest_sphere->colour * 0.5;")) +
            "\nwait until own/saves 2\nwait idle\nexpect own/wrong > 10000\nclick listing/own/first\nwait idle\n" +
            "expect listing/own/line-" + std::to_string(number) + " contains discriminant\nscreenshot " + out +
            "wrong.png\n";
  script += write + quoted(with_change(copy, line, "  const double discriminant = b * b - 4 * a * q;\n")) +
            "\nwait until own/saves 3\nwait idle\nexpect listing/own/line-" + std::to_string(number) +
            "/fault contains error\nscreenshot " + out + "error.png\n";
  script +=
      write +
      quoted(with_change(copy, "  double closest_t = infinity;\n",
                         "  for (volatile int i = 0;; i = i + 1) {}\n  double closest_t = infinity;\n")) +
      "\nwait until own/saves 4\nwait 1500\nclick listing/own/stop\nwait idle\n" +
      "expect listing/own/state contains Stopped\nclick listing/own/close\nwait idle\nexpect own/open off\nquit\n";
  const auto result = ps::test::play(script, folder, "1366x768", "--lesson cgfs_02_basic_ray_tracing/11");
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
}

/// A file that is named on the way of a scene or a picture is not compiled, and one from the dialog only after a click.
TEST(OwnListingWindow, NothingIsCompiledBeforeAClick) {
  const auto folder = std::filesystem::absolute(ps::fresh_output_folder("gui-own-refused"));
  const ps::test::Variable data("XDG_DATA_HOME", (folder / "data").string());
  const ps::test::Variable cache("XDG_CACHE_HOME", (folder / "cache").string());
  const std::string file = (folder / "strange.cpp").string();
  const std::string copy = ps::listing_copy(ps::test::listing_in("cgfs_02_basic_ray_tracing"));
  const std::string script = "wait idle\nwrite " + file + " " + quoted(copy) + "\ndrop " + file +
                             "\nwait idle\nexpect own/open off\nclick listing/open\nwait frames 5\ntype " +
                             quoted(file) +
                             "\nkey Enter\nwait idle\nexpect own/open off\nexpect listing/own/rights contains \"Go on "
                             "only if you know what is in it\"\n"
                             "screenshot " +
                             (folder / "asked.png").string() +
                             "\nclick listing/own/allow\nwait idle\nexpect own/open on\nexpect own/wrong 0\nquit\n";
  const auto result = ps::test::play(script, folder, "1366x768", "--lesson cgfs_02_basic_ray_tracing/11");
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
}

}  // namespace
}  // namespace own_listing_window_test
