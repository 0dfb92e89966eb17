#include "student/listing_kit.h"

#include <set>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "base/resources.h"
#include "textbook/listing_source.h"

namespace ps {
namespace {

namespace fs = std::filesystem;

/// The names between quotes in the #include lines of a header.
std::vector<std::string> included_names(const std::string& text) {
  constexpr std::string_view start = "#include \"";
  std::vector<std::string> names;
  for (const std::string& line : listing_lines(text))
    if (line.starts_with(start))
      names.push_back(line.substr(start.size(), line.find('"', start.size()) - start.size()));
  return names;
}

}  // namespace

void put_listing_kit(const fs::path& folder) {
  std::vector<std::string> waiting{"textbook/listing.h"};
  std::set<std::string> seen(waiting.begin(), waiting.end());
  while (!waiting.empty()) {
    const fs::path name = waiting.back();
    waiting.pop_back();
    const std::string text = read_whole_file(header_dir() / name);
    const fs::path copy = folder / kit_headers / name;
    std::error_code error;
    fs::create_directories(copy.parent_path(), error);  // where that fails, writing does
    write_file_atomically(copy, text, Durability::quick);
    for (std::string& more : included_names(text))
      if (seen.insert(more).second) waiting.push_back(std::move(more));
  }
  write_file_atomically(folder / kit_library, read_whole_file(listing_library()), Durability::quick);
}

}  // namespace ps
