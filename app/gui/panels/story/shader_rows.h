#pragma once
#include <string_view>
#include <vector>

#include "record/shader_listing.h"
#include "textbook/listing_view.h"

namespace ps::gui {

/// Which lines of a shader are shown.
enum class ShaderLinesShown {
  compiled,  ///< those that this program is made of, with the conditions that let them in
  whole      ///< all of the file
};

/// The lines of a shader file as rows of code. A compiler's message ("a shader does not compile: lighting.glsl:15(3):
/// error: ...") is shown beside its line without its place, if it is about this file.
std::vector<ListingRow> shader_rows(const ShaderFile& file, ShaderLinesShown shown, std::string_view message);

/// Which of the files the message is about; -1 for none.
int file_of_message(const std::vector<ShaderFile>& files, std::string_view message);

}  // namespace ps::gui
