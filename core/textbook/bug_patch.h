#pragma once
#include <string>
#include <vector>

/// Bugs for students to find. chapters/FOLDER/bugs/NAME.bug has three lines: a sentence that says what is seen, the
/// line of the listing as it is, behind "- ", and the line with the bug, behind "+ ". Both without the listing's
/// indentation.

namespace ps {

/// The lines of a text, without their ends.
std::vector<std::string> listing_lines(const std::string& source);

/// The content of such a file.
struct BugPatch {
  std::string symptom;       ///< one sentence
  std::string right, wrong;  ///< the line without and with the bug
};

/// Reads the text of a .bug file; `file` is for messages. Throws InputError with file and line.
BugPatch parse_bug(const std::string& text, const std::string& file);

/// The line that is wrong.
struct BugLine {
  int number = 0;     ///< in the listing, from 1
  std::string wrong;  ///< as the bug has it
  std::string right;  ///< in the listing
};

/// A listing with a bug in it, line for line.
struct PatchedListing {
  std::string text;
  BugLine line;
};

/// Puts the bug into the listing. Throws InputError for `file` (the .bug file), with its line, if the listing does not
/// have the line exactly once. Build and window both use this function.
PatchedListing patch_listing(const std::string& listing, const BugPatch& bug, const std::string& file);

}  // namespace ps
