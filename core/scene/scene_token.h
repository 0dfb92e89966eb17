#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/check.h"

namespace ps {

/// A piece of a scene file. Bare words are everything between blanks and punctuation: numbers, names and paths alike.
struct SceneToken {
  enum class Kind { word, quoted, punctuation, end };
  Kind kind = Kind::end;
  std::string text;  ///< without quotes; escapes resolved
  int line = 1;
  int column = 1;  ///< in characters, not bytes

  bool is(char punctuation) const { return kind == Kind::punctuation && text.size() == 1 && text[0] == punctuation; }
  /// For messages: 'radius', or "end of file".
  std::string shown() const;
};

/// Cuts a scene file into tokens, the last of which is `end`. Comments run from # to the end of the line; lines may end
/// in LF, CR LF or CR. Throws InputError for text that is not UTF-8-like (NUL, control characters, UTF-16), for an
/// unclosed quotation mark, and beyond `max_scene_tokens`.
std::vector<SceneToken> scene_tokens(std::string_view text, const std::string& file);

/// Largest number of tokens in one scene file; larger models belong into an OBJ file.
inline constexpr std::size_t max_scene_tokens = 4'000'000;

}  // namespace ps
