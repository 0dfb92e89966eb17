#pragma once
#include <optional>
#include <string_view>

#include "scene/canvas_item.h"
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
  switch (operation) {
  case CsgOperation::union_of:
    return "union";
  case CsgOperation::intersection:
    return "intersection";
  case CsgOperation::difference:
    return "difference";
  }
  return {};
}

constexpr std::string_view sides_key(Sides sides) {
  switch (sides) {
  case Sides::two:
    return "two";
  case Sides::front:
    return "front";
  }
  return {};
}

constexpr std::string_view blend_key(Blend blend) {
  switch (blend) {
  case Blend::replace:
    return "replace";
  case Blend::additive:
    return "additive";
  case Blend::subtractive:
    return "subtractive";
  }
  return {};
}

/// The form that a word names; nullopt if it names none. A form comes with its default measures.
std::optional<Form> form_named(std::string_view key);
std::optional<CsgOperation> operation_named(std::string_view key);
std::optional<Sides> sides_named(std::string_view key);
std::optional<Blend> blend_named(std::string_view key);

}  // namespace ps
