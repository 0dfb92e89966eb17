#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace ps {

/// A field of comma-separated values (RFC 4180): in quotes, with quotes inside doubled.
std::string quoted_csv_field(std::string_view text);

/// The same, in quotes only if a reader would otherwise take a part of it for a separator or for quotes.
std::string csv_field(std::string_view text);

/// The table with columns behind its last one: `heading` and one text for each row, both without the comma before them.
/// No field of the table may contain a line break.
std::string csv_with_columns(std::string_view csv, std::string_view heading, const std::vector<std::string>& rows);

}  // namespace ps
