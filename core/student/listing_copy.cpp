#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/check.h"
#include "base/spelling.h"
#include "student/own_listing.h"
#include "textbook/listing_source.h"

namespace ps {
namespace {

constexpr std::string_view origin_mark = "// Listing: ";
constexpr std::size_t lines_with_origin = 20;  // at most so far from the top

/// A routine in the lines of a listing: its first line is `begin`, that of its closing brace is `end`.
struct RoutinePlace {
  std::string name;
  std::size_t begin = 0, body = 0, end = 0;
};

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// The name before the first bracket of a line that begins a routine: "double f(" is f.
std::string routine_name(const std::string& line) {
  const std::size_t bracket = line.find('(');
  if (line.empty() || !is_word(line[0]) || bracket == std::string::npos) return {};
  std::size_t begin = bracket;
  while (begin > 0 && is_word(line[begin - 1])) --begin;
  return begin == 0 ? std::string() : line.substr(begin, bracket - begin);
}

/// Routines begin at the left edge and end with a brace there, as clang-format has it.
std::vector<RoutinePlace> routine_places(const std::vector<std::string>& lines) {
  std::vector<RoutinePlace> places;
  bool inside = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] == "namespace {") inside = true;
    if (lines[i] == "}  // namespace") break;
    const std::string name = inside ? routine_name(lines[i]) : std::string();
    if (name.empty()) continue;
    RoutinePlace place{name, i, i, i};
    while (place.body < lines.size() && !lines[place.body].ends_with('{') && !lines[place.body].ends_with(';'))
      ++place.body;
    if (place.body >= lines.size() || lines[place.body].ends_with(';')) continue;
    place.end = place.body;
    while (place.end < lines.size() && lines[place.end] != "}") ++place.end;
    if (place.end >= lines.size()) continue;
    places.push_back(place);
    i = place.end;
  }
  return places;
}

/// Leaves the body of a routine to be written.
void empty_routine(std::vector<std::string>& lines, std::string_view routine) {
  const std::vector<RoutinePlace> places = routine_places(lines);
  const auto place =
      std::find_if(places.begin(), places.end(), [&](const RoutinePlace& each) { return each.name == routine; });
  if (place == places.end()) {
    std::string known;
    for (const RoutinePlace& each : places) known += (known.empty() ? "" : ", ") + each.name;
    throw InputError(
        fmt::format("routine: found '{}', expected one of the listing: {}", shown_start(std::string(routine)), known));
  }
  const auto at = [&](std::size_t index) { return lines.begin() + static_cast<std::ptrdiff_t>(index); };
  const bool gives_nothing = lines[place->begin].starts_with("void ");
  lines.erase(at(place->body + 1), at(place->end));
  std::vector<std::string> body{"  // TODO: write this routine."};
  if (!gives_nothing) body.emplace_back("  return {};");
  lines.insert(at(place->body + 1), body.begin(), body.end());
}

}  // namespace

std::vector<std::string> listing_routines(const std::string& source) {
  std::vector<std::string> names;
  for (const RoutinePlace& place : routine_places(listing_lines(source))) names.push_back(place.name);
  return names;
}

std::string listing_copy(const NamedListing& listing, std::string_view routine) {
  std::vector<std::string> lines = listing_lines(listing_source({listing.folder, listing.key, listing.listing}));
  if (!routine.empty()) empty_routine(lines, routine);
  std::string text =
      fmt::format("// Your copy of the listing of {}, \"{}\". Change it and save: Pixelscope compiles it and shows\n"
                  "// its picture as B, beside that of the listing as A.\n{}{}\n",
                  listing.listing->source, listing.listing->label, origin_mark, listing.folder);
  std::string includes;
  for (const std::string& line : lines)
    if (line.starts_with("#include <")) includes += line + "\n";
  text += includes + (includes.empty() ? "" : "\n") + "#include \"textbook/listing.h\"\n\nnamespace ps {\n";
  bool inside = false;
  for (const std::string& line : lines) {
    if (line == "namespace {") inside = true;
    if (inside) text += line + "\n";
    if (line == "}  // namespace") break;
  }
  return text + "\n// What Pixelscope calls.\nvoid draw_listing(const BookScene& scene, BookCanvas& canvas) { "
                "draw(scene, canvas); "
                "}\n\n}  // namespace ps\n";
}

const NamedListing* copied_listing(const std::string& source) {
  const std::vector<std::string> lines = listing_lines(source);
  for (std::size_t i = 0; i < std::min(lines.size(), lines_with_origin); ++i) {
    if (!lines[i].starts_with(origin_mark)) continue;
    const std::string folder = lines[i].substr(origin_mark.size());
    for (const NamedListing& listing : listings())
      if (listing.folder == folder) return &listing;
  }
  return nullptr;
}

}  // namespace ps
