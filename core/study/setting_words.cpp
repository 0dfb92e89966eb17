#include "study/setting_words.h"

#include <algorithm>

#include <fmt/format.h>

#include "options/option.h"

namespace ps {

std::string setting_words(std::string_view assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos) return std::string(assignment);
  const Option* option = find_option(assignment.substr(0, equals));
  if (!option) return std::string(assignment);
  std::string_view value = assignment.substr(equals + 1);
  const auto found = std::find_if(option->choices.begin(), option->choices.end(),
                                  [&](const Choice& choice) { return choice.key == value; });
  if (found != option->choices.end()) value = found->label;
  return fmt::format("{}: {}", option->label, value);
}

std::string settings_in_words(std::string_view text, std::string_view separator) {
  std::string words;
  while (true) {
    const auto end = text.find(separator);
    words += setting_words(text.substr(0, end));
    if (end == std::string_view::npos) return words;
    words += separator;
    text.remove_prefix(end + separator.size());
  }
}

}  // namespace ps
