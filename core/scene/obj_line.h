#pragma once
#include <string>
#include <string_view>

#include "base/check.h"

namespace ps {

/// Walks through the words of one line of an OBJ or MTL file. Comments at its end are replaced by blanks.
class ObjLine {
 public:
  ObjLine(std::string& text, std::size_t begin, std::size_t end, int number, const std::string& file);

  /// The next word; empty at the end of the line.
  std::string_view next();
  /// What is left of the line without blanks around it.
  std::string_view rest();
  /// What next() or rest() returned last.
  std::string_view word() const { return part(word_begin_, word_end_); }
  /// Replaces the characters at the end of that word by blanks.
  void blank_word_end(std::size_t count);
  int number() const { return number_; }

  /// Throws InputError at the word that next() returned last.
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const;
  /// The last word as it appears in messages; "the end of the line" if there was none.
  std::string shown() const;
  /// The next word must be a decimal number that is finite, at most 1e12, and not so small that it turns into 0.
  void require_number();

 private:
  std::string_view part(std::size_t from, std::size_t to) const {
    return std::string_view(*text_).substr(from, to - from);
  }

  std::string* text_;
  std::size_t begin_, end_;
  std::size_t at_;
  std::size_t word_begin_;
  std::size_t word_end_;
  int number_;
  const std::string* file_;
};

/// Calls `use(line)` for each line; lines end in LF, CR LF or CR. Throws InputError for lines that are too long, for
/// UTF-16 and for NUL bytes. Blanks out a UTF-8 byte-order mark and joins lines that end in a backslash, keeping the
/// number of lines.
template <class Use>
int for_each_obj_line(std::string& text, const std::string& file, Use use);

void prepare_obj_text(std::string& text, const std::string& file);
void require_obj_line_length(std::size_t length, int number, const std::string& file);

template <class Use>
int for_each_obj_line(std::string& text, const std::string& file, Use use) {
  prepare_obj_text(text, file);
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    ++number;
    std::size_t end = begin;
    while (end < text.size() && text[end] != '\n' && text[end] != '\r') ++end;
    require_obj_line_length(end - begin, number, file);
    ObjLine line(text, begin, end, number, file);
    use(line);
    const bool pair = end + 1 < text.size() && text[end] == '\r' && text[end + 1] == '\n';
    begin = end + (pair ? 2 : 1);
  }
  return number;
}

}  // namespace ps
