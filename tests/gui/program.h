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

/// The same while `hand`, a piece of shell script, does with xdotool what people do. It begins once the script has
/// printed its first line, which is $line there; $window is the window for xdotool. An empty one does nothing. `before`
/// is put in front of the program, as for run_window().
WindowRun play_by_hand(const std::string& commands, const std::string& hand, const std::filesystem::path& folder,
                       const std::string& arguments = {}, const std::string& before = {});

std::string read_file(const std::filesystem::path& path);

}  // namespace ps::test
