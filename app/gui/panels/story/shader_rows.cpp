#include "gui/panels/story/shader_rows.h"

#include <optional>

#include "base/number_text.h"

namespace ps::gui {
namespace {

/// The number behind "lighting.glsl:" in a message.
std::optional<int> line_in(std::string_view message, const std::string& file) {
  const std::size_t at = message.find(file + ":");
  if (at == std::string_view::npos) return {};
  std::string_view behind = message.substr(at + file.size() + 1);
  return take_integer<int>(behind);
}

/// What is wrong: "error: syntax error, unexpected ..."
std::string_view without_place(std::string_view message) {
  const std::size_t at = message.find("error");
  return at == std::string_view::npos ? message : message.substr(at);
}

/// Does the line belong to what the program is made of? Of directives those that let the line behind them in.
bool is_made_of(const std::vector<ShaderLine>& lines, std::size_t index) {
  const ShaderLine& line = lines[index];
  if (!line.compiled || line.text.starts_with("#endif") || line.text.starts_with("#else")) return false;
  const bool condition = line.text.starts_with("#if") || line.text.starts_with("#elif");
  return !condition || (index + 1 < lines.size() && lines[index + 1].compiled);
}

}  // namespace

std::vector<ListingRow> shader_rows(const ShaderFile& file, ShaderLinesShown shown, std::string_view message) {
  const std::optional<int> wrong = line_in(message, file.name);
  std::vector<ListingRow> rows;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const ShaderLine& line = file.lines[i];
    if (shown == ShaderLinesShown::compiled && !is_made_of(file.lines, i) && line.number != wrong) continue;
    if (shown == ShaderLinesShown::compiled && line.text.empty() && (rows.empty() || rows.back().text.empty()))
      continue;
    ListingRow row;
    row.text = line.text;
    row.number = line.number;
    row.dimmed = !line.compiled;
    for (const ShaderValue& value : line.values) row.values.push_back({value.name, value.value});
    if (line.number == wrong) row.values.push_back({"on disk", std::string(without_place(message))});
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
