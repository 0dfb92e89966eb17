#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "record/event_fields.h"
#include "record/event_keys.h"

namespace ps::fields {

/// A member of an event, as a number made of its name: lists are checked for members that they leave out. If two names
/// gave one number, the check would miss a member and fail. (Under the sanitizers GCC 12 compares no addresses of
/// variables while it compiles.) FNV-1a: Fowler, Noll and Vo.
using MemberTag = std::uint64_t;
template <auto Member>
consteval MemberTag member_tag() {
  MemberTag tag = 14695981039346656037U;
  for (const char letter : __PRETTY_FUNCTION__) tag = (tag ^ static_cast<unsigned char>(letter)) * 1099511628211U;
  return tag;
}

/// One field of events of type E.
template <class E>
struct Row {
  std::string_view key;
  std::optional<FieldValue> (*read)(const E&) = nullptr;  ///< nullopt where this event does not have the field
  std::array<MemberTag, 3> members{};                     ///< of E that it shows
  bool (*present)(const E&) = nullptr;                    ///< nullptr: always
  FieldRole role = FieldRole::value;
  std::string_view label{};  ///< empty: the key with spaces for dashes
};

/// The fields of one type of event, declared once; everything that shows events follows from it. Specialisations have
/// `kind`, the event's key; `partners`, which events with another kind share if they can be each other's partner in two
/// stories; and `rows` in the order in which they are shown.
template <class E>
struct List;

inline FieldValue shape(bool value) { return value; }
inline FieldValue shape(int value) { return std::int64_t{value}; }
inline FieldValue shape(double value) { return value; }
inline FieldValue shape(const std::string& value) { return value; }
inline FieldValue shape(const PixelId& value) { return value; }
inline FieldValue shape(const std::vector<double>& value) { return value; }
inline FieldValue shape(const std::vector<bool>& value) { return value; }
inline FieldValue shape(const std::vector<Texel>& value) { return value; }
inline FieldValue shape(const Vec2i& v) {
  return std::vector<double>{static_cast<double>(v.x), static_cast<double>(v.y)};
}
inline FieldValue shape(const Vec2d& v) { return std::vector<double>{v.x, v.y}; }
inline FieldValue shape(const Vec3d& v) { return std::vector<double>{v.x, v.y, v.z}; }
template <class T, std::size_t N>
FieldValue shape(const std::array<T, N>& values) {
  return std::vector<std::conditional_t<std::is_same_v<T, bool>, bool, double>>(values.begin(), values.end());
}
template <class Enum>
requires std::is_enum_v<Enum> FieldValue shape(Enum value) { return std::string(event_key(value)); }

template <class T>
std::optional<FieldValue> shown(const T& value) {
  return shape(value);
}
template <class T>
std::optional<FieldValue> shown(const std::optional<T>& value) {
  return value ? std::optional(shape(*value)) : std::nullopt;
}

template <class E, class T>
E event_of(T E::*);

/// A member as it is. A member that is an empty std::optional is left out.
template <auto Member>
constexpr auto field(std::string_view key, bool (*present)(const decltype(event_of(Member))&) = nullptr) {
  using E = decltype(event_of(Member));
  return Row<E>{key, [](const E& event) { return shown(event.*Member); }, {member_tag<Member>()}, present};
}

/// The result of `read`, a lambda without captures, for some members.
template <auto... Members>
constexpr auto computed(std::string_view key, auto read, auto present) {
  using E = std::common_type_t<decltype(event_of(Members))...>;
  static_assert(std::is_empty_v<decltype(read)>);
  return Row<E>{key,
                [](const E& event) { return shown(decltype(read){}(event)); },
                {member_tag<Members>()...},
                static_cast<bool (*)(const E&)>(present)};
}
template <auto... Members>
constexpr auto computed(std::string_view key, auto read) {
  return computed<Members...>(key, read, nullptr);
}

/// One member of each element of a list.
template <auto List, auto Of>
constexpr auto each(std::string_view key, bool (*present)(const decltype(event_of(List))&) = nullptr) {
  using E = decltype(event_of(List));
  const auto read = [](const E& event) {
    using Value = std::remove_cvref_t<decltype((event.*List).front().*Of)>;
    std::vector<std::conditional_t<std::is_same_v<Value, bool>, bool, double>> values;
    for (const auto& element : event.*List) values.push_back(element.*Of);
    return values;
  };
  return computed<List>(key, read, present);
}

/// The field says what the event is about.
template <class E>
constexpr Row<E> subject(Row<E> row) {
  row.role = FieldRole::subject;
  return row;
}

/// The field has another name for people.
template <class E>
constexpr Row<E> labelled(std::string_view label, Row<E> row) {
  row.label = label;
  return row;
}

/// How many members the rows show.
template <class E>
consteval std::size_t members_shown() {
  std::array<MemberTag, 3 * List<E>::rows.size()> seen{};
  std::size_t count = 0;
  for (const Row<E>& row : List<E>::rows)
    for (const MemberTag tag : row.members) {
      bool known = tag == 0;
      for (std::size_t i = 0; i < count; ++i) known = known || seen[i] == tag;
      if (!known) seen[count++] = tag;
    }
  return count;
}

struct Anything {
  template <class T>
  operator T&() const&;  // NOLINT(google-explicit-constructor)
  template <class T>
  operator T&&() const&&;  // NOLINT(google-explicit-constructor)
};

/// How many members the aggregate E has: the most values that it can be initialised with.
template <class E, std::size_t N = 1>
consteval std::size_t member_count() {
  constexpr bool takes = []<std::size_t... I>(std::index_sequence<I...>) {
    return requires { E{(void(I), Anything{})...}; };
  }
  (std::make_index_sequence<N>{});
  if constexpr (takes)
    return member_count<E, N + 1>();
  else
    return N - 1;
}

}  // namespace ps::fields
