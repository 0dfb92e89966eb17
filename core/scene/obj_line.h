#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/check.h"

namespace ps {

/// A decimal number as model files write it, or what was expected in its place ("a number below 1e12").
struct ObjNumber {
  double value = 0;
  const char* fault = nullptr;
};

/// Finite, below 1e12, and not so small that it turns into 0; the double that is nearest to the text.
ObjNumber read_obj_number(std::string_view word);

/// Walks through the words of one line of an OBJ or MTL file. A `#` ends the line, also behind a number without a
/// blank. Names may hold it: see begin_names().
class ObjLine {
 public:
  ObjLine(std::string_view text, int number, const std::string& file) : text_(text), number_(number), file_(&file) {}

  /// The next word; empty at the end of the line.
  std::string_view next();
  /// Whether no word is left.
  bool at_end() const { return ObjLine(*this).next().empty(); }
  /// Names may follow: from here on a `#` is one of their letters ("#1 red", "wood #2"), unless it stands
  /// alone between blanks, where it begins a comment.
  void begin_names();
  /// The rest of the line without blanks around it.
  std::string_view rest();
  /// begin_names(), then rest().
  std::string_view name();
  /// The word or text that next() or rest() returned last.
  std::string_view word() const { return text_.substr(word_begin_, word_end_ - word_begin_); }
  int number() const { return number_; }

  /// InputError at the word that next() returned last.
  InputError error(const std::string& found, const std::string& expected) const;
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const { throw error(found, expected); }
  /// The last word as it appears in messages; "the end of the line" if there was none.
  std::string shown() const;
  /// The next word, which must be a number.
  double require_number();

 private:
  std::string_view text_;
  std::size_t at_ = 0, word_begin_ = 0, word_end_ = 0;
  bool in_names_ = false;
  int number_;
  const std::string* file_;
};

/// The lines of an OBJ or MTL file, which end in LF, CR LF or CR. A backslash at the end joins a line with the next,
/// but not behind a comment. Throws InputError for lines that are too long, for UTF-16 and for NUL bytes.
class ObjLines {
 public:
  /// Keeps both. `most_bytes` is the largest length of a line.
  ObjLines(std::string_view text, const std::string& file, std::size_t most_bytes);
  /// nullopt at the end of the file. A line is valid until the next call.
  std::optional<ObjLine> next();
  /// Number of lines of the file up to here.
  int count() const { return count_; }

 private:
  std::string_view take();

  std::string_view text_;
  const std::string& file_;
  std::size_t most_bytes_;
  std::size_t at_ = 0;
  int count_ = 0;
  std::string joined_;
};

/// The names that a statement may mean, the likeliest first: as it stands, without double quotes around it, and without
/// what follows " #".
std::vector<std::string> meant_names(std::string_view name);

}  // namespace ps
