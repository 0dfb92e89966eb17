#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace ps {

/// Reads the words of a PNM file one after another, past white space and comments (# to the end of the line).
class PnmText {
 public:
  PnmText(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  /// The next word; InputError at the end of the file, with what was expected.
  std::string_view word(std::string_view expected);
  /// The next word as a whole number in [low, high].
  std::int64_t integer(std::int64_t low, std::int64_t high, std::string_view what);
  /// The next word as a finite decimal number.
  double real(std::string_view what);
  /// The text behind the one white-space character after the last word.
  std::string_view rest();
  /// Bytes not read yet.
  std::size_t left() const { return bytes_.size() - at_; }
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

 private:
  void skip_space();
  std::string_view bytes_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace ps
