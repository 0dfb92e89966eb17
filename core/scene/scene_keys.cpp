#include "scene/scene_keys.h"

#include "base/enumerators.h"

namespace ps {
namespace {

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
  for (const CsgOperation operation : all_enumerators<CsgOperation>)
    if (operation_key(operation) == key) return operation;
  return {};
}

std::string_view form_name(const Form& form) {
  return std::visit([]<class OneForm>(const OneForm&) { return form_key<OneForm>; }, form);
}

std::string_view operation_name(CsgOperation operation) { return operation_key(operation); }

}  // namespace ps
