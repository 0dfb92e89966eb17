#include "document/document_provenance.h"

#include "base/resources.h"
#include "document/permalink.h"
#include "document/permalink_file.h"

namespace ps {

Provenance document_provenance(const Document& document, Side side, const std::optional<Machinery>& drawn_by,
                               const std::filesystem::path& file) {
  Provenance result = provenance_of(side_of(document, side).settings, drawn_by);
  result.more.emplace_back("scene", portable_name(document.scene_name));
  result.more.emplace_back("permalink", file.empty() ? permalink(document) : permalink_for_file(file, document));
  return result;
}

}  // namespace ps
