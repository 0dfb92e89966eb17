#include "gui/panels/story/shader_rows.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include "base/number_text.h"

namespace ps::gui {
namespace {

/// A line of the text, and the place that messages give it.
struct PlacedLine {
  std::string text;
  std::size_t file = 0;  ///< index into ShaderText::files
  int number = 0;        ///< in that file, from 1; 0 = in none: before the first, or added to make them one text
};

/// Follows the lines "#line NUMBER FILE".
std::vector<PlacedLine> placed_lines(const ShaderText& shader) {
  constexpr std::string_view line_directive = "#line ";
  std::vector<PlacedLine> lines;
  std::istringstream text(shader.text);
  std::size_t file = 0;
  int next = 0;
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with(line_directive)) {
      const bool guard = line.starts_with("#define INCLUDED_");
      lines.push_back({std::move(line), file, guard ? 0 : next});
      next += next > 0;
      continue;
    }
    std::string_view place = std::string_view(line).substr(line_directive.size());
    next = take_integer<int>(place).value_or(0);
    place.remove_prefix(std::min<std::size_t>(1, place.size()));
    file = take_integer<std::size_t>(place).value_or(0);
    lines.push_back({std::move(line), file, 0});
  }
  return lines;
}

/// The number behind "lighting.glsl:" in a message.
std::optional<int> line_in(std::string_view message, const std::string& file) {
  const std::size_t at = message.find(file + ":");
  const bool begins = at == 0 || (at != std::string_view::npos && message[at - 1] == ' ');  // not "volume_vertex.glsl:"
  if (!begins) return {};
  std::string_view behind = message.substr(at + file.size() + 1);
  return take_integer<int>(behind);
}

/// What is wrong: "error: syntax error, unexpected ..."
std::string_view without_place(std::string_view message) {
  const std::size_t at = message.find("error");
  return at == std::string_view::npos ? message : message.substr(at);
}

}  // namespace

std::vector<ListingRow> shader_rows(const ShaderText& shader) {
  std::vector<ListingRow> rows;
  for (PlacedLine& line : placed_lines(shader)) {
    ListingRow row;
    row.number = static_cast<int>(rows.size()) + 1;
    row.dimmed = line.text.starts_with("#line ");
    row.text = std::move(line.text);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<ShaderFilePlace> file_places(const ShaderText& shader) {
  std::vector<ShaderFilePlace> places;
  int row = 0;
  for (const PlacedLine& line : placed_lines(shader)) {
    ++row;
    if (line.number != 1) continue;
    const std::string& name = shader.files[line.file];
    if (std::none_of(places.begin(), places.end(), [&](const ShaderFilePlace& place) { return place.name == name; }))
      places.push_back({name, row});
  }
  return places;
}

std::map<int, std::string> shader_faults(const ShaderText& shader, std::string_view message) {
  std::map<int, std::string> faults;
  int row = 0;
  for (const PlacedLine& line : placed_lines(shader)) {
    ++row;
    if (line.number > 0 && line_in(message, shader.files[line.file]) == line.number)
      faults[row] = without_place(message);
  }
  return faults;
}

}  // namespace ps::gui
