#pragma once
#include <string>
#include <vector>

namespace ps::gui {

/// Something that was given a name to be had again: a preset's options, a bookmark's permalink.
struct KeptEntry {
  std::string name;
  std::string text;
  bool operator==(const KeptEntry&) const = default;
};

/// From lines of a name, a tab and a text. Lines of another form are left out.
std::vector<KeptEntry> parse_kept(const std::string& lines);
/// The lines that parse_kept() reads back.
std::string kept_lines(const std::vector<KeptEntry>& entries);
/// Adds an entry at the front, in place of one of the same name. Tabs and line breaks of its name become blanks, and
/// blanks at its ends go. Answers whether a name was left.
bool keep_entry(std::vector<KeptEntry>& entries, std::string name, std::string text);

}  // namespace ps::gui
