#pragma once
#include "document/document.h"

namespace ps::cli {

/// Prints the rows of the canvas triangles at a pixel by both rules. Throws InputError where there is none.
void print_rows(const Document& document, Vec2i pixel, bool json);

}  // namespace ps::cli
