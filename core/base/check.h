#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace ps {

/// A place in a text file. Lines and columns count from 1; 0 means "the file as a whole".
struct SourcePlace {
  std::string file;
  int line = 0;
  int column = 0;
};

/// Bad input from outside (a file, a command line, a permalink). Never thrown for a programmer's mistake.
/// what() reads "file:line:column: found X, expected Y".
class InputError : public std::runtime_error {
 public:
  InputError(SourcePlace place, std::string found, std::string expected);
  /// For input without a position, such as a command-line value; what() is the message unchanged.
  explicit InputError(const std::string& message);

  const SourcePlace& place() const noexcept { return place_; }
  const std::string& found() const noexcept { return found_; }
  const std::string& expected() const noexcept { return expected_; }

 private:
  SourcePlace place_;
  std::string found_;
  std::string expected_;
};

/// Prints the failed condition with its place and aborts. Called by PS_ASSERT only.
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line, std::string_view message);

}  // namespace ps

/// A programmer's mistake ends the program in every build type: a wrong picture is worse than none.
#define PS_ASSERT(condition, message)                                                                                  \
  do {                                                                                                                 \
    if (!(condition)) ::ps::assertion_failed(#condition, __FILE__, __LINE__, message);                                 \
  } while (false)
