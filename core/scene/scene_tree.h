#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace ps {

struct SceneEntry;

/// A value in a scene file, before anyone asks what it means.
struct SceneTerm {
  enum class Kind {
    word,      ///< 0.5, red, models/die.obj
    quoted,    ///< "two words"
    tuple,     ///< (1, 2, 3)
    list,      ///< [0, 1, 2]
    sequence,  ///< 0, 1, 2, red
    size,      ///< 600 x 400
    rotation,  ///< <45 degrees around the Y axis>; items are its words
    linear,    ///< linear (0.5, 0.2, 1): a colour whose full value is 1
    block      ///< { entries }
  };
  Kind kind = Kind::word;
  std::string text;
  std::vector<SceneTerm> items;
  std::vector<SceneEntry> entries;
  int line = 0;
  int column = 0;

  /// Several terms in round, square or no brackets.
  bool is_list() const { return kind == Kind::tuple || kind == Kind::list || kind == Kind::sequence; }
  /// For messages: what the file says, shortened.
  std::string shown() const;
};

/// One `key = value` or `key { ... }`; in lists of vertices and triangles the key may be missing (empty).
struct SceneEntry {
  std::string key;
  SceneTerm value;
  int line = 0;
  int column = 0;
};

/// Reads the notation of CGFS into a tree: assignments and blocks, in the file's order, nested at most
/// `max_scene_nesting` deep. Throws InputError with the place; an unclosed brace is reported where it was opened.
std::vector<SceneEntry> scene_tree(std::string_view text, const std::string& file);

inline constexpr int max_scene_nesting = 32;

}  // namespace ps
