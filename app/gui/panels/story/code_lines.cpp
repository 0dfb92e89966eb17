#include "gui/panels/story/code_lines.h"

#include <algorithm>

namespace ps::gui {
namespace {

/// How much of text that begins after `blanks` blanks comes into a line of its own, where no blank ends it in time.
std::size_t part_of_word(const std::string& text, std::size_t blanks, std::size_t characters) {
  const std::size_t last = text.find_last_of("(,.:[{<>", characters - 1);
  const bool enough = last != std::string::npos && last >= blanks + 4;
  return enough ? last + 1 : characters;
}

}  // namespace

std::string code_lines(const std::string& text, std::size_t characters) {
  const std::size_t start = std::min(text.find_first_not_of(' '), text.size());
  const std::string indent(std::min(start + 4, characters / 2), ' ');
  std::string lines, rest = text;
  while (rest.size() > characters) {
    const std::size_t content = std::min(rest.find_first_not_of(' '), rest.size());
    const std::size_t blank = rest.rfind(' ', characters);
    if (blank == std::string::npos || blank < content) {
      const std::size_t part = part_of_word(rest, content, characters);
      lines.append(rest, 0, part).push_back('\n');
      rest.replace(0, part, indent);
      continue;
    }
    lines.append(rest, 0, blank).push_back('\n');
    const std::size_t word = std::min(rest.find(' ', blank + 1), rest.size()) - blank - 1;
    const bool fits = word <= characters;  // with less in front of it, perhaps
    rest.replace(0, blank + 1, indent, 0, fits ? characters - word : indent.size());
  }
  return lines + rest;
}

}  // namespace ps::gui
