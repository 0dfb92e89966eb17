#pragma once
#include <string>

#include "document/document.h"

namespace ps::cli {

/// How the split among stages is put out.
struct StageOutput {
  std::string picture;  ///< file of the pixels in the colours of their causes; empty: none
  bool json = false;
};

/// Prints how the difference between the document's picture A and the picture with `b` divides among the stages of
/// drawing triangles. Throws InputError where one of the two is not the rasterizer's.
int print_stages(const Document& document, const Settings& b, const StageOutput& output);

}  // namespace ps::cli
