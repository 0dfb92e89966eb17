#pragma once
#include <optional>
#include <string_view>

#include "base/enumerators.h"
#include "scene/solid.h"

namespace ps {

/// The words with which scene files name kinds and choices, each written once: what reads and writes scene files, edits
/// and names asks here.

/// The block of a form.
template <class OneForm>
inline constexpr std::string_view form_key{};
template <>
inline constexpr std::string_view form_key<Ball> = "sphere";
template <>
inline constexpr std::string_view form_key<Plane> = "plane";
template <>
inline constexpr std::string_view form_key<Rectangle> = "rectangle";
template <>
inline constexpr std::string_view form_key<Brick> = "box";
template <>
inline constexpr std::string_view form_key<Cylinder> = "cylinder";

constexpr std::string_view operation_key(CsgOperation operation) {
  return operation == CsgOperation::union_of ? "union" : enumerator_key(operation);
}

/// The form that a word names; nullopt if it names none. A form comes with its default measures.
std::optional<Form> form_named(std::string_view key);
std::optional<CsgOperation> operation_named(std::string_view key);

}  // namespace ps
