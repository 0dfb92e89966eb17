#include "gui/panels/story/shader_rows.h"

#include <charconv>
#include <optional>

namespace ps::gui {
namespace {

/// The number behind "lighting.glsl:" in a message.
std::optional<int> line_in(std::string_view message, const std::string& file) {
  const std::size_t at = message.find(file + ":");
  if (at == std::string_view::npos) return {};
  const std::string_view digits = message.substr(at + file.size() + 1);
  int number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return error == std::errc() ? std::optional(number) : std::nullopt;
}

}  // namespace

std::vector<ListingRow> shader_rows(const ShaderFile& file, std::string_view message) {
  const std::optional<int> wrong = line_in(message, file.name);
  std::vector<ListingRow> rows;
  for (const ShaderLine& line : file.lines) {
    ListingRow row;
    row.text = line.text;
    row.number = line.number;
    row.dimmed = !line.compiled;
    for (const ShaderValue& value : line.values) row.values.push_back({value.name, value.value});
    if (line.number == wrong) row.values.push_back({"on disk", std::string(message)});
    rows.push_back(std::move(row));
  }
  return rows;
}

int file_of_message(const std::vector<ShaderFile>& files, std::string_view message) {
  for (std::size_t i = 0; i < files.size(); ++i)
    if (line_in(message, files[i].name)) return static_cast<int>(i);
  return -1;
}

}  // namespace ps::gui
