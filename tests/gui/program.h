#pragma once
#include <filesystem>
#include <string>

namespace ps::test {

/// How the window ended and what it said.
struct WindowRun {
  int status = -1;  ///< exit status; -1 if a signal ended it
  std::string output, errors;
};

/// Runs build/bin/pixelscope with `arguments` (shell syntax) and waits for its end. `before` is put in front of the
/// command ("env -u DISPLAY").
WindowRun run_window(const std::string& arguments, const std::string& before = {});

/// Writes `commands` into FOLDER/script.script and plays it in a window of the given size ("1024x768").
WindowRun play(const std::string& commands, const std::filesystem::path& folder, const std::string& size,
               const std::string& arguments = {});

std::string read_file(const std::filesystem::path& path);

}  // namespace ps::test
