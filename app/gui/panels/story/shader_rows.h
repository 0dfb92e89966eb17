#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "record/shader_listing.h"
#include "textbook/listing_view.h"

namespace ps::gui {

/// The lines of a shader's text as rows of code, numbered from 1.
std::vector<ListingRow> shader_rows(const ShaderText& shader);

/// Where a file begins in the text.
struct ShaderFilePlace {
  std::string name;
  int row = 0;  ///< number of its first row
};
/// All files in the order of the text, each once.
std::vector<ShaderFilePlace> file_places(const ShaderText& shader);

/// What a compiler says of rows ("a shader does not compile: lighting.glsl:15(3): error: ..."), by their numbers and
/// without its place; empty if the text does not have that line.
std::map<int, std::string> shader_faults(const ShaderText& shader, std::string_view message);

}  // namespace ps::gui
