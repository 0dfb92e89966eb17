#include "hardware/condition.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

#include "base/check.h"
#include "base/number_text.h"

namespace ps::hardware {
namespace {

bool begins_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// Two signs that belong together, before those that are one of them.
constexpr std::array operators{"&&", "||", "==", "!=", "<=", ">=", "<", ">", "%", "!", "(", ")"};

std::vector<std::string> tokens_of(std::string_view text) {
  std::vector<std::string> tokens;
  while (!text.empty()) {
    if (std::isspace(static_cast<unsigned char>(text[0]))) {
      text.remove_prefix(1);
      continue;
    }
    std::size_t length = 0;
    while (length < text.size() && is_of_name(text[length])) ++length;
    for (const std::string_view sign : operators)
      if (length == 0 && text.starts_with(sign)) length = sign.size();
    if (length == 0) throw InputError(fmt::format("#if: found '{}', expected a condition", text));
    tokens.emplace_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  return tokens;
}

/// Recursive descent, one function for each level of precedence.
class ConditionReader {
 public:
  ConditionReader(std::vector<std::string> tokens, const Definitions& definitions)
      : tokens_(std::move(tokens)), definitions_(definitions) {}

  int read() {
    const int value = either();
    if (next_ < tokens_.size()) refuse();
    return value;
  }

 private:
  bool take(std::string_view token) {
    if (next_ == tokens_.size() || tokens_[next_] != token) return false;
    ++next_;
    return true;
  }
  [[noreturn]] void refuse() const {
    throw InputError(fmt::format("#if: found {}, expected a condition",
                                 next_ < tokens_.size() ? "'" + tokens_[next_] + "'" : "the end of the line"));
  }

  int either() {
    int value = both();
    while (take("||")) value = (both() != 0) | (value != 0);
    return value;
  }
  int both() {
    int value = equal();
    while (take("&&")) value = (equal() != 0) & (value != 0);
    return value;
  }
  int equal() {
    int value = ordered();
    for (;;) {
      if (take("=="))
        value = value == ordered();
      else if (take("!="))
        value = value != ordered();
      else
        return value;
    }
  }
  int ordered() {
    int value = remainder();
    for (;;) {
      if (take("<="))
        value = value <= remainder();
      else if (take(">="))
        value = value >= remainder();
      else if (take("<"))
        value = value < remainder();
      else if (take(">"))
        value = value > remainder();
      else
        return value;
    }
  }
  int remainder() {
    int value = single();
    while (take("%")) {
      const int by = single();
      if (by == 0) throw InputError("#if: found a division by 0");
      value %= by;
    }
    return value;
  }
  int single() {
    if (take("!")) return single() == 0;
    if (take("(")) {
      const int value = either();
      if (!take(")")) refuse();
      return value;
    }
    if (next_ == tokens_.size() || !is_of_name(tokens_[next_][0])) refuse();
    const std::string& token = tokens_[next_++];
    if (begins_name(token[0])) {
      const auto found = definitions_.find(token);
      return found == definitions_.end() ? 0 : found->second;
    }
    if (const auto value = parse_integer<int>(token)) return *value;
    throw InputError(fmt::format("#if: found '{}', expected a whole number", token));
  }

  std::vector<std::string> tokens_;
  const Definitions& definitions_;
  std::size_t next_ = 0;
};

}  // namespace

Definitions read_definitions(std::string_view text) {
  Definitions definitions;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string define, name;
    int value = 0;
    if (words >> define >> name >> value && define == "#define") definitions[name] = value;
  }
  return definitions;
}

bool condition_holds(std::string_view condition, const Definitions& definitions) {
  return ConditionReader(tokens_of(condition), definitions).read() != 0;
}

std::vector<std::string> names_in(std::string_view condition) {
  std::vector<std::string> names;
  for (std::string& token : tokens_of(condition))
    if (begins_name(token[0]) && std::find(names.begin(), names.end(), token) == names.end())
      names.push_back(std::move(token));
  return names;
}

}  // namespace ps::hardware
