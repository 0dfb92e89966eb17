#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ps::hardware {

/// Names of the preprocessor and their numbers.
using Definitions = std::map<std::string, int, std::less<>>;

/// The lines "#define NAME NUMBER" of a text; all others are passed over.
Definitions read_definitions(std::string_view text);

/// Whether the condition of an #if holds: whole numbers and names with ! % == != < > <= >= && || and parentheses. A
/// name without a definition counts as 0. Throws InputError for anything else.
bool condition_holds(std::string_view condition, const Definitions& definitions);

/// The names in a condition, in the order in which they first occur.
std::vector<std::string> names_in(std::string_view condition);

}  // namespace ps::hardware
