#pragma once
#include <string>

#include "document/document.h"

namespace ps::cli {

/// The rows of the canvas triangles at a pixel by both rules, as tables or as JSON. Throws InputError where there is
/// none.
std::string rows_text(const Document& document, Vec2i pixel, bool json);

}  // namespace ps::cli
