#include "base/check.h"
#include "engine/claim.h"
#include "engine/measured_pictures.h"
#include "options/option.h"

namespace ps {

Document claim_document(const Claim& claim, const Document& now) { return state_document(claim.state, now); }

Document mutated_document(const Claim& claim, const Document& now) {
  Document document = state_document(claim.mutation.state, now);
  for (const std::string& key : claim.mutation.reset) {
    const Option* option = find_option(key);
    PS_ASSERT(option, "the parser lets only known options through");
    option->set(document.a.settings, option->default_value());
    option->set(document.b.settings, option->default_value());
  }
  return document;
}

ClaimResult check_claim(const Claim& claim, Progress& progress, MeasuredPictures* pictures) {
  MeasuredPictures own;
  if (!pictures) pictures = &own;
  ClaimResult result;
  const Document document = claim_document(claim, pictures->last());
  result.value = measure(claim.metric, document, progress, pictures);
  // Made from the claim's document, so that a scene that stays the same is not loaded again.
  result.mutated_value = measure(claim.mutation.metric, mutated_document(claim, document), progress, pictures);
  result.holds = claim.bound.holds(result.value);
  result.has_teeth = !claim.bound.holds(result.mutated_value);
  return result;
}

}  // namespace ps
