#include "document/document_provenance.h"

#include "base/resources.h"
#include "document/permalink.h"

namespace ps {

Provenance document_provenance(const Document& document, Side side, const std::optional<Machinery>& drawn_by) {
  Provenance result = provenance_of(side_of(document, side).settings, drawn_by);
  result.more.emplace_back("scene", portable_name(document.scene_name));
  result.more.emplace_back("permalink", permalink(document));
  return result;
}

}  // namespace ps
