#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace ps {

/// One row of comma-separated values (RFC 4180) with its line end. A field is in quotes, with quotes inside doubled,
/// only if a reader would otherwise take a part of it for a separator or for quotes. The line ends with "\n", as in
/// every other text file of the program, and not with the "\r\n" of the RFC: readers of tables accept both, and grep,
/// sed and awk would take the "\r" for a part of the last field.
std::string csv_row(const std::vector<std::string>& fields);

/// The table with columns behind its last one: `heading`, and the fields that `fields_of` gives for each row, from 0.
/// No field of `csv` may contain a line break.
std::string csv_with_columns(std::string_view csv, const std::vector<std::string>& heading,
                             const std::function<std::vector<std::string>(std::size_t row)>& fields_of);

}  // namespace ps
