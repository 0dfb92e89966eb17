#pragma once
#include <cstddef>
#include <string_view>

namespace ps {

/// Has the enum a name for this value? The compilers write a value with a name as "ps::FillRule::inclusive" and one
/// without as "(ps::FillRule)7".
template <auto Value>
constexpr bool is_enumerator() {
  constexpr std::string_view function = __PRETTY_FUNCTION__, before = "Value = ";
  return function[function.find(before) + before.size()] != '(';
}

/// How many enumerators an enum has, whose values are 0, 1, 2 and so on without a gap.
template <class Enum, std::size_t Known = 0>
constexpr std::size_t enumerator_count() {
  if constexpr (is_enumerator<static_cast<Enum>(Known)>())
    return enumerator_count<Enum, Known + 1>();
  else
    return Known;
}

}  // namespace ps
