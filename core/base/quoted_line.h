#pragma once
#include <exception>
#include <string>

#include "base/check.h"

namespace ps {

/// Stands before each line of a quotation, which is shown in letters of one width.
inline constexpr const char* quotation_indent = "    ";

/// The line of the file at the place, and below it a caret under the column; each behind a line break and indented, for
/// letters of one width. Of a long line the part around the column. Empty for a place without line and column, and
/// where the file is not one that can be read.
std::string quoted_line(const SourcePlace& place);

/// The text to show below the message of a failure: the line that an InputError is about; then, where it stands for
/// several (base/input_errors.h), each of the others with its line. Begins with a line break, or is empty.
std::string quoted_lines(const std::exception& failure);

}  // namespace ps
