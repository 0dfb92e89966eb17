#include "base/csv.h"

#include <algorithm>

namespace ps {
namespace {

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace

std::string csv_row(const std::vector<std::string>& fields) {
  std::string row;
  for (const std::string& field : fields) {
    if (&field != fields.data()) row += ',';
    row += csv_field(field);
  }
  return row + '\n';
}

std::string csv_with_columns(std::string_view csv, const std::vector<std::string>& heading,
                             const std::function<std::vector<std::string>(std::size_t row)>& fields_of) {
  std::string text;
  for (std::size_t line = 0; !csv.empty(); ++line) {
    const auto end = std::min(csv.find('\n'), csv.size());
    text += csv.substr(0, end);
    text += ',' + csv_row(line == 0 ? heading : fields_of(line - 1));
    csv.remove_prefix(std::min(end + 1, csv.size()));
  }
  return text;
}

}  // namespace ps
