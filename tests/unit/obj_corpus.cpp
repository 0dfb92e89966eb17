#include "obj_corpus.h"

#include <atomic>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

namespace ps::test {

ModelFolder::ModelFolder() {
  static std::atomic<int> number{0};
  path_ = std::filesystem::temp_directory_path() / fmt::format("pixelscope-test-{}-{}", getpid(), ++number);
  std::filesystem::create_directories(path_);
}

ModelFolder::~ModelFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string ModelFolder::write(const std::string& name, const std::string& text) const {
  const auto file = path_ / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
  return file.string();
}

}  // namespace ps::test
