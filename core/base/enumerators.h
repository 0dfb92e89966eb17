#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

/// Names and values of enums whose values are 0, 1, 2 and so on without a gap, from the compiler.

namespace ps {

/// A value as the compilers write it: "ps::FillRule::inclusive", or "(ps::FillRule)7" for one without a name.
template <auto Value>
constexpr std::string_view value_as_written() {
  constexpr std::string_view function = __PRETTY_FUNCTION__, before = "Value = ";
  constexpr std::size_t begin = function.find(before) + before.size();
  return function.substr(begin, function.find_first_of(";]", begin) - begin);
}

/// Has the enum a name for this value?
template <auto Value>
constexpr bool is_enumerator() {
  return value_as_written<Value>().front() != '(';
}

/// How many enumerators an enum has.
template <class Enum, std::size_t Known = 0>
constexpr std::size_t enumerator_count() {
  if constexpr (is_enumerator<static_cast<Enum>(Known)>())
    return enumerator_count<Enum, Known + 1>();
  else
    return Known;
}

/// All of them, in their order.
template <class Enum>
inline constexpr auto all_enumerators = [] {
  std::array<Enum, enumerator_count<Enum>()> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Enum>(i);
  return all;
}();

/// The letters of enumerator_key().
template <auto Value>
inline constexpr auto key_letters = [] {
  constexpr std::string_view written = value_as_written<Value>();
  constexpr std::string_view name = written.substr(written.rfind(':') + 1);
  std::array<char, name.size()> letters{};
  for (std::size_t i = 0; i < name.size(); ++i) letters[i] = name[i] == '_' ? '-' : name[i];
  return letters;
}();

/// The keys of all enumerators, in their order.
template <class Enum>
inline constexpr auto enumerator_keys = []<std::size_t... i>(std::index_sequence<i...>) {
  return std::array{
      std::string_view(key_letters<static_cast<Enum>(i)>.data(), key_letters<static_cast<Enum>(i)>.size())...};
}
(std::make_index_sequence<enumerator_count<Enum>()>{});

/// The word for an enumerator in files, which is its name in the code: "before-range" for TestOutcome::before_range.
/// Renaming one changes what files say.
template <class Enum>
constexpr std::string_view enumerator_key(Enum value) {
  return enumerator_keys<Enum>.at(static_cast<std::size_t>(value));
}

/// The enumerator with this key; nullopt if there is none.
template <class Enum>
constexpr std::optional<Enum> enumerator_named(std::string_view key) {
  for (const Enum value : all_enumerators<Enum>)
    if (enumerator_key(value) == key) return value;
  return {};
}

/// Throws InputError "across: found 'speed', expected one of time work memory", where `what` is "across".
[[noreturn]] void refuse_key(std::string_view what, std::string_view key, std::span<const std::string_view> known);

/// The enumerator with this key; refuses others.
template <class Enum>
Enum parse_enumerator(std::string_view what, std::string_view key) {
  if (const auto value = enumerator_named<Enum>(key)) return *value;
  refuse_key(what, key, enumerator_keys<Enum>);
}

}  // namespace ps
