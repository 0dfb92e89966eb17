#include "support/golden.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "image/difference.h"
#include "image/file.h"

namespace ps {
namespace {

/// Beside bin/, in the build folder that this program belongs to.
std::filesystem::path output_folder() {
  return std::filesystem::path(PIXELSCOPE_BIN_DIR).parent_path() / "test-output";
}

/// What the running test adds to the names of its folders: other tests, and the same one with another parameter, run
/// meanwhile and may use the same name.
std::string own_part() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  if (test == nullptr) return {};
  std::string part = fmt::format("{}-{}", test->test_suite_name(), test->name());  // with "/" and the parameter
  std::replace(part.begin(), part.end(), '/', '-');
  return "-" + part;
}

struct Distance {
  std::int64_t pixels = 0;
  int level = 0;
  int x = -1, y = -1;  ///< the first pixel that differs
};

Distance distance(const Image<Rgb8>& a, const Image<Rgb8>& b) {
  Distance result;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const Rgb8 p = a.at(x, y);
      const Rgb8 q = b.at(x, y);
      if (p == q) continue;
      if (result.pixels++ == 0) {
        result.x = x;
        result.y = y;
      }
      result.level = std::max({result.level, std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
    }
  }
  return result;
}

}  // namespace

bool expect_matches(const std::string& name, const Image<Rgb8>& actual, const Image<Rgb8>& expected,
                    const GoldenTolerance& tolerance) {
  const auto folder = output_folder();
  std::filesystem::create_directories(folder);
  if (actual.width() != expected.width() || actual.height() != expected.height()) {
    ADD_FAILURE() << name << ": found " << actual.width() << " x " << actual.height() << ", expected "
                  << expected.width() << " x " << expected.height();
    if (!actual.empty()) save_image(folder / (name + "-actual.png"), actual);
    return false;
  }
  const Distance found = distance(actual, expected);
  if (found.pixels <= tolerance.max_differing_pixels && found.level <= tolerance.max_level) return true;

  save_image(folder / (name + "-expected.png"), expected);
  save_image(folder / (name + "-actual.png"), actual);
  save_image(folder / (name + "-difference.png"), difference_picture(expected, actual, {.gain = 32}));
  ADD_FAILURE() << name << ": " << found.pixels << " pixels differ (at most " << tolerance.max_differing_pixels
                << " may), by up to " << found.level << " levels (at most " << tolerance.max_level
                << "); the first is (" << found.x << ", " << found.y << "). See "
                << (folder / (name + "-{expected,actual,difference}.png")).string();
  return false;
}

bool expect_matches(const std::string& name, const Image<Rgb8>& actual, const std::filesystem::path& expected,
                    const GoldenTolerance& tolerance) {
  return expect_matches(name, actual, load_levels(expected), tolerance);
}

std::filesystem::path reference_path(const std::string& name) {
  return std::filesystem::path(PIXELSCOPE_TEST_DIR) / "golden" / "reference" / name;
}

std::filesystem::path fresh_output_folder(const std::string& name) {
  auto folder = output_folder() / (name + own_part());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace ps
