#pragma once
#include <string_view>
#include <type_traits>
#include <utility>

#include "options/option.h"

namespace ps {

/// Its address names a member of Settings.
template <auto Member>
inline constexpr char member_id = 0;

/// The option with this Option::member.
const Option& option_with(const void* member);

/// The option that sets this member of Settings; each member has exactly one.
template <auto Member>
const Option& option_of() {
  static const Option& found = option_with(&member_id<Member>);
  return found;
}

/// The key with which the option table names the value of a choice: "edge-function" for Coverage::edge_function.
template <auto Member>
std::string_view choice_key(std::remove_cvref_t<decltype(std::declval<Settings>().*Member)> value) {
  return option_of<Member>().choices.at(static_cast<std::size_t>(value)).key;
}

}  // namespace ps
