#include "textbook/bug_patch.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"

namespace ps {
namespace {

constexpr int place_of_right = 2;  // line of the .bug file

std::string without_indentation(const std::string& line) {
  return line.substr(std::min(line.find_first_not_of(' '), line.size()));
}

/// The text behind "- " or "+ ".
std::string marked_line(const std::vector<std::string>& lines, std::size_t index, char mark, const std::string& file) {
  const std::string& line = lines[index];
  if (line.size() < 3 || line[0] != mark || line[1] != ' ' || line[2] == ' ')
    throw InputError({file, static_cast<int>(index) + 1, 1}, fmt::format("'{}'", line),
                     fmt::format("'{} ' and a line of the listing without its indentation", mark));
  return line.substr(2);
}

}  // namespace

std::vector<std::string> listing_lines(const std::string& source) {
  std::vector<std::string> lines;
  std::size_t start = 0;
  while (start < source.size()) {
    const auto end = std::min(source.find('\n', start), source.size());
    lines.push_back(source.substr(start, end - start));
    start = end + 1;
  }
  return lines;
}

BugPatch parse_bug(const std::string& text, const std::string& file) {
  const std::vector<std::string> lines = listing_lines(text);
  if (lines.size() != 3)
    throw InputError({file, 0, 0}, fmt::format("{} lines", lines.size()),
                     "three: what is seen, '- ' and the line as it is, '+ ' and the line with the bug");
  if (lines[0].empty() || lines[0].back() != '.')
    throw InputError({file, 1, 1}, fmt::format("'{}'", lines[0]), "a sentence that says what is seen");
  BugPatch bug{lines[0], marked_line(lines, 1, '-', file), marked_line(lines, 2, '+', file)};
  if (bug.right == bug.wrong) throw InputError({file, 3, 1}, "the line as it is", "the line with the bug");
  return bug;
}

PatchedListing patch_listing(const std::string& listing, const BugPatch& bug, const std::string& file) {
  const std::vector<std::string> lines = listing_lines(listing);
  PatchedListing patched;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool here = without_indentation(lines[i]) == bug.right;
    const std::string wrong = here ? lines[i].substr(0, lines[i].size() - bug.right.size()) + bug.wrong : "";
    const int number = static_cast<int>(i) + 1;
    if (here && patched.line.number > 0)
      throw InputError({file, place_of_right, 1},
                       fmt::format("a line that listing.cpp has twice, as {} and {}", patched.line.number, number),
                       "one that it has once");
    if (here) patched.line = {number, wrong, lines[i]};
    patched.text += (here ? wrong : lines[i]) + '\n';
  }
  if (patched.line.number == 0)
    throw InputError({file, place_of_right, 1}, "a line that listing.cpp has not", "one that it has once");
  return patched;
}

}  // namespace ps
