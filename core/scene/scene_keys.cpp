#include "scene/scene_keys.h"

#include <initializer_list>

namespace ps {
namespace {

template <class Enum>
std::optional<Enum> choice_named(std::string_view word, std::initializer_list<Enum> all,
                                 std::string_view (*key)(Enum)) {
  for (const Enum one : all)
    if (key(one) == word) return one;
  return {};
}

template <class... Forms>
std::optional<Form> form_among(std::string_view word, const std::variant<Forms...>&) {
  static_assert((!form_key<Forms>.empty() && ...));
  std::optional<Form> found;
  ((form_key<Forms> == word ? static_cast<void>(found = Forms{}) : void()), ...);
  return found;
}

}  // namespace

std::optional<Form> form_named(std::string_view key) { return form_among(key, Form{}); }

std::optional<CsgOperation> operation_named(std::string_view key) {
  return choice_named(key, {CsgOperation::union_of, CsgOperation::intersection, CsgOperation::difference},
                      operation_key);
}

std::optional<Sides> sides_named(std::string_view key) {
  return choice_named(key, {Sides::two, Sides::front}, sides_key);
}

std::optional<Blend> blend_named(std::string_view key) {
  return choice_named(key, {Blend::replace, Blend::additive, Blend::subtractive}, blend_key);
}

std::string_view form_name(const Form& form) {
  return std::visit([]<class OneForm>(const OneForm&) { return form_key<OneForm>; }, form);
}

std::string_view operation_name(CsgOperation operation) { return operation_key(operation); }

}  // namespace ps
