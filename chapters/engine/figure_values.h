#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/check.h"
#include "math/vec.h"

namespace ps {

/// A word of a figure's description, with its place.
struct FigureWord {
  std::string text;
  SourcePlace place;
};

/// Cuts a line at its blanks. Brackets hold a word together: "(1, 2)" is one.
std::vector<FigureWord> words_of_line(std::string_view line, const SourcePlace& start);

/// Reads a finite number; throws InputError at the word.
double number_of(const FigureWord& word);
/// Reads "(x, y)"; throws InputError at the word.
Vec2d pair_of(const FigureWord& word);

struct FigureRange {
  double low = -1e6, high = 1e6;
};

/// "KEY=VALUE" words of a kind of figure. Each value has a default, and a key that was not asked for is an error.
class FigureValues {
 public:
  explicit FigureValues(std::vector<FigureWord> words);

  /// Throws InputError at the value if it is not a number or outside the range.
  double number(std::string_view key, double otherwise, FigureRange range = {});
  /// Numbers separated by commas.
  std::vector<double> numbers(std::string_view key, std::vector<double> otherwise, FigureRange range = {});
  /// Two words with a comma between them.
  std::pair<std::string, std::string> names(std::string_view key, const std::pair<std::string, std::string>& otherwise);
  /// "(x,y)" in any number, one behind the other.
  std::vector<Vec2d> pairs(std::string_view key, std::vector<Vec2d> otherwise);
  /// One of these words; the first is the default.
  std::string_view word(std::string_view key, const std::vector<std::string_view>& known);
  /// Words of `known`, separated by commas; by default all.
  std::vector<std::string_view> words(std::string_view key, const std::vector<std::string_view>& known);
  /// Throws InputError at the value of the key, or at the last one if that has its default.
  [[noreturn]] void refuse(std::string_view key, const std::string& expected) const;
  /// Throws InputError for a key that was not asked for.
  void require_all_used() const;

 private:
  struct Value {
    FigureWord key, value;
    bool used = false;
  };
  const FigureWord* find(std::string_view key);
  std::vector<Value> values_;
  std::vector<std::string_view> asked_;
};

}  // namespace ps
