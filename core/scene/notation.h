#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ps {

/// The page about the notation of scenes (assets/scenes/README.md), for the window and for tests.

struct NotationField {
  std::string key;       ///< "intensity"
  std::string value;     ///< what may be given: "0 to 1", "(x, y, z)"
  std::string standard;  ///< what holds without it
  std::string meaning;
};

/// One construct, under a heading of its own.
struct NotationPart {
  std::string name;               ///< "light", "triangle on the canvas"
  std::string text;               ///< what it is, in Markdown
  std::string example;            ///< a whole scene; empty if the page has none
  std::filesystem::path picture;  ///< of the example
  bool surface = false;           ///< it also takes the fields of a surface
  std::vector<NotationField> fields;
};

struct Notation {
  std::string text;  ///< the paragraph before the first construct, in Markdown: units, and how values are written
  std::vector<NotationPart> parts;
};

/// Reads the page. Throws InputError naming the line of a table's row that has not four cells.
Notation parse_notation(std::string_view page, const std::filesystem::path& file);
/// The page that the program ships with. Throws InputError if it cannot be read.
Notation scene_notation();

}  // namespace ps
