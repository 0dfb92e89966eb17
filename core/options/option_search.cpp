#include "options/option_search.h"

#include <string>

#include "base/word_search.h"

namespace ps {

bool option_matches(const Option& option, std::string_view wanted) {
  std::string values;
  for (const Choice& choice : option.choices) {
    values += choice.label;
    values += ' ';
  }
  return has_words(
      wanted, {option.key, option.label, option.group, option.help.what, option.help.source, option.keywords, values});
}

}  // namespace ps
