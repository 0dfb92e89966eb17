#include "base/version.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>

namespace version_test {
namespace {

TEST(Version, IsTheOneInCMakeLists) {
  std::ifstream file("CMakeLists.txt");
  std::stringstream text;
  text << file.rdbuf();
  const std::string content = text.str();
  std::smatch match;
  ASSERT_TRUE(std::regex_search(content, match, std::regex("project\\(pixelscope VERSION ([0-9.]+)")));
  EXPECT_EQ(match[1].str(), ps::version());
}

}  // namespace
}  // namespace version_test
