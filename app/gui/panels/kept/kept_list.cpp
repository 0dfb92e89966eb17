#include "gui/panels/kept/kept_list.h"

#include <algorithm>
#include <sstream>

namespace ps::gui {

std::vector<KeptEntry> parse_kept(const std::string& lines) {
  std::vector<KeptEntry> entries;
  std::istringstream text(lines);
  for (std::string line; std::getline(text, line);) {
    const std::size_t tab = line.find('\t');
    if (tab == std::string::npos || tab == 0) continue;
    entries.push_back({line.substr(0, tab), line.substr(tab + 1)});
  }
  return entries;
}

std::string kept_lines(const std::vector<KeptEntry>& entries) {
  std::string lines;
  for (const KeptEntry& entry : entries) lines += entry.name + '\t' + entry.text + '\n';
  return lines;
}

bool keep_entry(std::vector<KeptEntry>& entries, std::string name, std::string text) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
  const std::size_t first = name.find_first_not_of(' ');
  if (first == std::string::npos) return false;
  name = name.substr(first, name.find_last_not_of(' ') - first + 1);
  std::erase_if(entries, [&](const KeptEntry& entry) { return entry.name == name; });
  entries.insert(entries.begin(), {std::move(name), std::move(text)});
  return true;
}

}  // namespace ps::gui
