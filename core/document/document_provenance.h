#pragma once
#include <optional>

#include "document/document.h"
#include "render/provenance.h"

namespace ps {

/// The provenance of what one side of a document shows, with its scene and the permalink that shows it again.
Provenance document_provenance(const Document& document, Side side, const std::optional<Machinery>& drawn_by = {});

}  // namespace ps
