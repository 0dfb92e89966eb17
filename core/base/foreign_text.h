#pragma once
#include <string>
#include <string_view>

namespace ps {

/// Text that somebody else wrote (a compiler, a student's program, a file), safe for a terminal: lines of readable
/// characters in UTF-8. Control characters but for the line feed and the tab, the C1 controls U+0080 to U+009F, marks
/// that change the direction of writing, and bytes that are not UTF-8 become '?', one for each character or byte.
std::string foreign_text(std::string_view text);

/// How many bytes at the beginning are text in UTF-8: all of them, or those before the first that are not.
std::size_t bytes_of_utf8(std::string_view text);

}  // namespace ps
