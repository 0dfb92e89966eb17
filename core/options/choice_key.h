#pragma once
#include <string_view>
#include <type_traits>
#include <utility>

#include "options/option.h"

namespace ps {

/// The only option in which the two differ.
const Option& option_that_differs(const Settings& one, const Settings& other);

/// The option that sets this member of Settings; each member has exactly one.
template <auto Member>
const Option& option_of() {
  static const Option& found = [&]() -> const Option& {
    Settings one, other;
    one.*Member = {};
    other.*Member = static_cast<std::remove_cvref_t<decltype(other.*Member)>>(1);
    return option_that_differs(one, other);
  }();
  return found;
}

/// The key with which the option table names the value of a choice: "edge-function" for Coverage::edge_function.
template <auto Member>
std::string_view choice_key(std::remove_cvref_t<decltype(std::declval<Settings>().*Member)> value) {
  return option_of<Member>().choices.at(static_cast<std::size_t>(value)).key;
}

}  // namespace ps
