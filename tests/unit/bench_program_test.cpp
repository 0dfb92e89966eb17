#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include "support/trials.h"

namespace bench_program_test {
namespace {

const std::string program = std::string(PIXELSCOPE_BIN_DIR) + "/pixelscope-bench";

int status_of(const std::string& arguments) {
  const int status = std::system((program + " " + arguments + " >/dev/null 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Nobody measures with a sanitized program, so none is built.
class BenchProgram : public testing::Test {
 protected:
  void SetUp() override {
    if (ps::test::trial_divisor > 1) GTEST_SKIP() << "not built for a sanitizer";
  }
};

TEST_F(BenchProgram, WritesOneJsonRowForEachBenchThatMatches) {
  const auto file = std::filesystem::temp_directory_path() / ("pixelscope-bench-" + std::to_string(getpid()) + ".json");
  ASSERT_EQ(status_of("memory/clear --repeats 1 --json " + file.string()), 0);
  std::ifstream stream(file);
  const auto rows = nlohmann::json::parse(stream);
  std::filesystem::remove(file);
  ASSERT_EQ(rows.size(), 4u);
  for (const auto& row : rows) {
    EXPECT_EQ(row.at("name").get<std::string>().rfind("memory/clear/", 0), 0u);
    EXPECT_EQ(row.at("unit"), "GB/s");
    EXPECT_GT(row.at("ours").get<double>(), 0);
    EXPECT_TRUE(row.at("yardstick").is_null());
    EXPECT_TRUE(row.at("yardstick_name").is_null());
    EXPECT_TRUE(row.at("ratio").is_null());
    EXPECT_FALSE(row.at("processor").get<std::string>().empty());
  }
}

TEST_F(BenchProgram, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(status_of("no-such-bench"), 2);
  EXPECT_EQ(status_of("memory --repeats 0"), 2);
  EXPECT_EQ(status_of("memory/clear/1024x768 --repeats 1 --json /no/such/folder/out.json"), 2);
  EXPECT_EQ(status_of("--list"), 0);
}

}  // namespace
}  // namespace bench_program_test
