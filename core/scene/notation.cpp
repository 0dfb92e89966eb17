#include "scene/notation.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "base/read_file.h"
#include "base/resources.h"
#include "base/word_search.h"

namespace ps {
namespace {

constexpr std::string_view heading = "## ", fence = "```", surface_words = "Fields of a [surface](#material) too.";

/// The cells between the bars of a table's row.
std::vector<std::string> cells_of(std::string_view row) {
  std::vector<std::string> cells;
  row.remove_prefix(1);
  while (!row.empty()) {
    const auto end = std::min(row.find('|'), row.size());
    cells.emplace_back(trimmed(row.substr(0, end)));
    row.remove_prefix(std::min(end + 1, row.size()));
  }
  return cells;
}

std::string without_ticks(std::string_view text) {
  if (text.size() > 1 && text.front() == '`' && text.back() == '`') text = text.substr(1, text.size() - 2);
  return std::string(text);
}

/// Takes the lines of the page one after the other.
class NotationReader {
 public:
  explicit NotationReader(const std::filesystem::path& file) : file_(file) {}

  void take(std::string_view line) {
    ++line_;
    if (in_example_) return example_line(line);
    if (line.starts_with(heading)) {
      page.parts.emplace_back().name = line.substr(heading.size());
      rows_ = 0;
      return;
    }
    if (page.parts.empty()) return before(line);
    if (line.starts_with(fence))
      in_example_ = true;
    else if (line.starts_with("!["))
      last().picture = file_.parent_path() / line.substr(line.find('(') + 1, line.find(')') - line.find('(') - 1);
    else if (line.starts_with("|"))
      row(line);
    else if (!line.empty())
      add_line(last().text, line);
    const auto words = last().text.find(surface_words);
    if (words == std::string::npos) return;
    last().surface = true;
    last().text = trimmed(std::string_view(last().text).substr(0, words));
  }

  Notation page;

 private:
  NotationPart& last() { return page.parts.back(); }

  static void add_line(std::string& text, std::string_view line) {
    text += (text.empty() ? "" : " ") + std::string(line);
  }

  /// Keeps the last paragraph before the first construct.
  void before(std::string_view line) {
    if (between_) page.text.clear();
    between_ = line.empty();
    if (!between_) add_line(page.text, line);
  }

  void example_line(std::string_view line) {
    if (line.starts_with(fence))
      in_example_ = false;
    else
      last().example += std::string(line) + "\n";
  }

  /// The first two rows of a table are its head.
  void row(std::string_view line) {
    if (++rows_ <= 2) return;
    std::vector<std::string> cells = cells_of(line);
    if (cells.size() != 4)
      throw InputError(fmt::format("{}:{}: found a row of {} cells, expected field, value, default and what it is",
                                   file_.string(), line_, cells.size()));
    last().fields.push_back({without_ticks(cells[0]), cells[1], cells[2], cells[3]});
  }

  const std::filesystem::path& file_;
  int line_ = 0, rows_ = 0;
  bool in_example_ = false, between_ = false;
};

}  // namespace

Notation parse_notation(std::string_view page, const std::filesystem::path& file) {
  NotationReader reader(file);
  while (!page.empty()) {
    const auto end = std::min(page.find('\n'), page.size());
    reader.take(page.substr(0, end));
    page.remove_prefix(std::min(end + 1, page.size()));
  }
  return std::move(reader.page);
}

Notation scene_notation() {
  const std::filesystem::path file = scene_dir() / "README.md";
  return parse_notation(read_whole_file(file.string()), file);
}

}  // namespace ps
