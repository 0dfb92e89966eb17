#include <algorithm>

#include "base/number_text.h"
#include "student/compile_listing.h"
#include "textbook/listing_source.h"

namespace ps {
namespace {

constexpr std::size_t most_messages = 100;
constexpr std::size_t longest_message = 500;  // bytes
constexpr std::string_view place_start = "listing.cpp:";

struct MessageWord {
  std::string_view word;
  MessageKind kind;
};
constexpr MessageWord message_words[] = {{"fatal error: ", MessageKind::error}, {"error: ", MessageKind::error},
                                         {"Fatal error: ", MessageKind::error},  // of the assembler
                                         {"Error: ", MessageKind::error},       {"warning: ", MessageKind::warning},
                                         {"note: ", MessageKind::note}};

/// Reads a number and the colon behind it off the front.
bool take_number(std::string_view& text, int& number) {
  std::string_view rest = text;
  const auto found = take_integer<int>(rest);
  if (!found || !rest.starts_with(':')) return false;
  number = *found;
  text = rest.substr(1);
  return true;
}

std::string shortened(std::string_view text) {
  return text.size() <= longest_message ? std::string(text) : std::string(text.substr(0, longest_message)) + "...";
}

/// "listing.cpp:12:5: error: ..." or "/usr/include/x.h:3:1: error: ...".
bool read_message(std::string_view line, CompilerMessage& message) {
  const bool in_file = line.starts_with(place_start);
  if (in_file) {
    line.remove_prefix(place_start.size());
    if (!take_number(line, message.line)) return false;
    take_number(line, message.column);
  }
  for (const auto& [word, kind] : message_words) {
    const std::size_t at = line.find(word);
    if (at == std::string_view::npos || (in_file && at > 1)) continue;
    message.kind = kind;
    const std::string_view words = line.substr(at + word.size());
    if (in_file)
      message.text = shortened(words);
    else if (line.substr(0, at).find(".s:") != std::string_view::npos)  // in the compiler's own file
      message.text = "assembler: " + shortened(words);
    else
      message.text = shortened(line);
    return true;
  }
  return false;
}

/// The linker's message for a name that is not defined, or defined twice.
bool read_linker_message(std::string_view line, CompilerMessage& message) {
  const std::size_t at = std::min(line.find("undefined reference to "), line.find("multiple definition of "));
  if (at == std::string_view::npos) return false;
  message = {MessageKind::error, 0, 0, shortened(line.substr(at, line.find(';', at) - at))};
  if (line.find("draw_listing(") != std::string_view::npos)
    message.text = "There is no routine void draw_listing(const BookScene& scene, BookCanvas& canvas) in namespace ps.";
  return true;
}

}  // namespace

std::vector<CompilerMessage> compiler_messages(const std::string& text) {
  std::vector<CompilerMessage> messages;
  for (const std::string& line : listing_lines(text)) {
    if (messages.size() == most_messages) break;
    CompilerMessage message;
    // That the linker failed says less than what it missed.
    if (line.find("ld returned") != std::string::npos || line.find("linker command failed") != std::string::npos)
      continue;
    if (read_message(line, message) || read_linker_message(line, message)) messages.push_back(std::move(message));
  }
  return messages;
}

}  // namespace ps
