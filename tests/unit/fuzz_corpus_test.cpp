// Every kept file of tests/corpus and every scene that ships, and random changes of them for a bounded time: read or
// refused, never anything else. PIXELSCOPE_TEST_SEED repeats a run, PIXELSCOPE_FUZZ_SECONDS lengthens it. `tests/run
// --fuzz` goes on with libFuzzer.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <random>

#include "base/atomic_file.h"
#include "fuzz/mend_png.h"
#include "fuzz/mutate.h"
#include "fuzz/targets.h"
#include "support/environment.h"

namespace fuzz_corpus_test {
namespace {

using ps::fuzz::Outcome;
using ps::fuzz::Target;

std::vector<std::string> kept_files(const Target& target) {
  std::vector<std::filesystem::path> paths;
  std::vector<std::string> folders{"tests/corpus/" + std::string(target.name)};
  if (target.name == "scene") folders.emplace_back("assets/scenes");
  for (const std::string& folder : folders)
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.is_regular_file() && entry.path().extension() != ".json") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> files;
  files.reserve(paths.size());
  for (const auto& path : paths) files.push_back(ps::read_whole_file(path));
  return files;
}

class Fuzz : public testing::TestWithParam<Target> {};

TEST_P(Fuzz, KeptFilesAndChangesOfThemAreReadOrRefused) {
  const Target& target = GetParam();
  const auto seed = ps::test::test_seed();
  const std::chrono::duration<double> time(ps::test::number_from("PIXELSCOPE_FUZZ_SECONDS", 1));
  const std::vector<std::string> files = kept_files(target);
  ASSERT_GE(files.size(), 5U);
  std::mt19937_64 random(seed);
  std::size_t read = 0, refused = 0;
  const auto run = [&](const std::string& bytes) {
    try {
      (target.run(bytes) == Outcome::read ? read : refused) += 1;
    } catch (const std::exception& error) {
      const auto file = std::filesystem::temp_directory_path() / ("pixelscope-finding." + std::string(target.name));
      ps::write_file_atomically(file, bytes);
      FAIL() << error.what() << "; the bytes are kept in " << file;
    }
  };
  for (const std::string& bytes : files) run(bytes);
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; !HasFatalFailure() && (i < 50 || std::chrono::steady_clock::now() - start < time); ++i) {
    std::string bytes = ps::fuzz::mutated(files[random() % files.size()], files, random);
    if (target.name == "png" && random() % 4 != 0) ps::fuzz::mend_png(bytes);
    run(bytes);
  }
  std::cout << "PIXELSCOPE_TEST_SEED=" << seed << ": " << read << " read, " << refused << " refused\n";
  EXPECT_GT(read, files.size() / 4) << "some changes are harmless";
  EXPECT_GT(refused, 10U) << "the changes have teeth";
}

INSTANTIATE_TEST_SUITE_P(Targets, Fuzz, testing::ValuesIn(ps::fuzz::targets().begin(), ps::fuzz::targets().end()),
                         [](const auto& target) {
                           std::string name(target.param.name);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace fuzz_corpus_test
