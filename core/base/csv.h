#pragma once
#include <string>
#include <string_view>

namespace ps {

/// A field of comma-separated values (RFC 4180): in quotes, with quotes inside doubled.
std::string quoted_csv_field(std::string_view text);

/// The same, in quotes only if a reader would otherwise take a part of it for a separator or for quotes.
std::string csv_field(std::string_view text);

}  // namespace ps
