#pragma once
#include <filesystem>
#include <string>

#include "image/image.h"

namespace ps {

/// How far a picture may be from its reference.
struct GoldenTolerance {
  std::int64_t max_differing_pixels = 0;
  int max_level = 255;  ///< largest difference of one channel; 0 = equal
};

/// Expects `actual` to match the picture file `expected`. On failure the test fails with the counts, and writes
/// NAME-expected, NAME-actual and NAME-difference.png (gain 32) into build/test-output/. Returns whether it matched.
bool expect_matches(const std::string& name, const Image<Rgb8>& actual, const std::filesystem::path& expected,
                    const GoldenTolerance& tolerance = {});

/// The same against a picture at hand.
bool expect_matches(const std::string& name, const Image<Rgb8>& actual, const Image<Rgb8>& expected,
                    const GoldenTolerance& tolerance = {});

/// tests/golden/reference/NAME.
std::filesystem::path reference_path(const std::string& name);

/// A fresh, empty folder for files that a test writes, below build/test-output/; kept for a look afterwards. Each
/// test has its own, also where two give the same name: tests run side by side.
std::filesystem::path fresh_output_folder(const std::string& name);

}  // namespace ps
