#include "support/run_cli.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "document/command_line.h"
#include "support/emulated.h"

namespace ps::test {
namespace {

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

ProgramResult run_cli(const std::vector<std::string>& arguments) {
  const ScratchFolder folder;
  std::string command = emulator() + " " PIXELSCOPE_BIN_DIR "/pixelscope-cli";
  for (const std::string& argument : arguments) command += " " + shell_quote(argument);
  command += " >" + shell_quote(folder.file("out")) + " 2>" + shell_quote(folder.file("err")) + " </dev/null";
  const int status = std::system(command.c_str());
  ProgramResult result;
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.out = content(folder.file("out"));
  result.err = content(folder.file("err"));
  return result;
}

ProgramResult run_cli_well(const std::vector<std::string>& arguments) {
  ProgramResult result = run_cli(arguments);
  EXPECT_EQ(result.status, 0) << result.err;
  return result;
}

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "pixelscope-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder can be made");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string ScratchFolder::write(const std::string& name, const std::string& text) const {
  std::filesystem::create_directories((path_ / name).parent_path());
  std::ofstream(path_ / name, std::ios::binary) << text;
  return file(name);
}

std::vector<std::string> ScratchFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(path_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace ps::test
