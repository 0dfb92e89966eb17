#include "base/quoted_line.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "base/archived_file.h"
#include "base/foreign_text.h"
#include "base/input_errors.h"
#include "base/read_file.h"

namespace ps {
namespace {

constexpr std::size_t most_quoted = 72;       // bytes; also a narrow window shows them
constexpr std::size_t kept_before = 36;       // of them before the column
constexpr std::size_t longest_line = 100000;  // of a line that is looked at
constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 28;

bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }

/// Bytes before the place are cut where a character begins.
std::size_t character_at(std::string_view line, std::size_t place) {
  while (place > 0 && place < line.size() && !begins_character(line[place])) --place;
  return place;
}

/// The byte at which a character begins; columns count characters.
std::size_t byte_of(std::string_view line, int character) {
  std::size_t byte = 0;
  for (; byte < line.size(); ++byte)
    if (begins_character(line[byte]) && --character < 0) break;
  return byte;
}

}  // namespace

std::string quoted_line(const SourcePlace& place) {
  if (place.line < 1 || place.column < 1 || !is_any_file(place.file)) return {};
  std::istringstream file;
  try {
    file.str(read_whole_file(place.file, largest_file));
  } catch (const InputError&) {
    return {};
  }
  std::string line;
  for (int number = 0; number < place.line; ++number)
    if (!std::getline(file, line)) return {};
  if (line.size() > longest_line) return {};
  if (line.ends_with('\r')) line.pop_back();
  std::replace(line.begin(), line.end(), '\t', ' ');
  const std::size_t column = byte_of(line, place.column - 1);
  std::size_t first = 0, last = line.size();
  if (line.size() > most_quoted) {
    first = character_at(line, column > kept_before ? std::min(column - kept_before, line.size() - most_quoted) : 0);
    last = character_at(line, std::min(first + most_quoted, line.size()));
  }
  // Bytes that are not text become marks, one for each.
  const std::string before = foreign_text(std::string_view(line).substr(first, column - first)),
                    behind = foreign_text(std::string_view(line).substr(column, last - column));
  const auto letters = std::count_if(before.begin(), before.end(), begins_character);
  return fmt::format("\n{}{}{}\n{}{}^", quotation_indent, before, behind, quotation_indent,
                     std::string(static_cast<std::size_t>(letters), ' '));
}

std::string quoted_lines(const std::exception& failure) {
  const auto* input = dynamic_cast<const InputError*>(&failure);
  if (input == nullptr) return {};
  std::string text = quoted_line(input->place());
  if (const auto* several = dynamic_cast<const InputErrors*>(&failure))
    for (std::size_t i = 1; i < several->all().size(); ++i) {
      std::string message = several->all()[i].what();
      std::replace(message.begin(), message.end(), '\n', ' ');
      text += "\n" + message + quoted_line(several->all()[i].place());
    }
  return text;
}

}  // namespace ps
