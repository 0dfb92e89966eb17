#pragma once
#include <filesystem>
#include <optional>

#include "document/document.h"
#include "render/provenance.h"

namespace ps {

/// The provenance of what one side of a document shows, with its scene and the permalink that shows it again. `file`:
/// the file that it is for, from which the permalink's paths are to be found; empty = not a file to open.
Provenance document_provenance(const Document& document, Side side, const std::optional<Machinery>& drawn_by = {},
                               const std::filesystem::path& file = {});

}  // namespace ps
