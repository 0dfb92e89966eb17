#include "base/csv.h"

#include <algorithm>

#include "base/check.h"

namespace ps {

std::string quoted_csv_field(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string csv_field(std::string_view text) {
  return text.find_first_of(",\"\r\n") == std::string_view::npos ? std::string(text) : quoted_csv_field(text);
}

std::string csv_with_columns(std::string_view csv, std::string_view heading, const std::vector<std::string>& rows) {
  std::string text;
  std::size_t line = 0;
  while (!csv.empty()) {
    const auto end = std::min(csv.find('\n'), csv.size());
    PS_ASSERT(line <= rows.size(), "each row of the table has its text");
    text += std::string(csv.substr(0, end)) + "," + (line == 0 ? std::string(heading) : rows[line - 1]) + "\n";
    csv.remove_prefix(std::min(end + 1, csv.size()));
    ++line;
  }
  return text;
}

}  // namespace ps
