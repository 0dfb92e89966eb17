#include "engine/glossary.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/read_file.h"
#include "base/resources.h"
#include "engine/markdown.h"
#include "engine/words.h"

namespace ps {
namespace {

constexpr std::size_t largest_glossary = 1 << 20;
constexpr std::string_view entry_mark = "## ";

/// The key by which words are compared: case and hyphens do not count, so that a link can write hyphens for blanks.
std::string key_of_words(std::string_view words) {
  std::string key = in_lower_case(words);
  std::replace(key.begin(), key.end(), '-', ' ');
  return key;
}

/// A heading of the glossary and the text below it.
struct RawEntry {
  std::vector<std::string> words;  ///< the term, then its forms
  int line = 0;                    ///< of the heading
  std::string text;                ///< from the line after it
};

std::vector<std::string> words_in_heading(std::string_view line) {
  std::vector<std::string> words;
  while (!line.empty()) {
    const auto end = std::min(line.find(';'), line.size());
    if (const auto word = without_blanks(line.substr(0, end)); !word.empty()) words.emplace_back(word);
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return words;
}

/// Text in front of the first heading is for those who edit the file.
std::vector<RawEntry> raw_entries(std::string_view text) {
  std::vector<RawEntry> entries;
  for (int line = 1; !text.empty(); ++line) {
    const std::string_view here = take_line(text);
    if (here.starts_with(entry_mark))
      entries.push_back({words_in_heading(here.substr(entry_mark.size())), line, {}});
    else if (!entries.empty())
      entries.back().text.append(here).append("\n");
  }
  return entries;
}

/// Each word in lower case with the term that it is a form of. Read before any definition, since these have links.
const std::map<std::string, std::string>& terms_of_words() {
  static const std::map<std::string, std::string> terms = [] {
    std::map<std::string, std::string> found;
    std::string text;
    try {
      text = read_whole_file(glossary_file(), largest_glossary);
    } catch (const InputError&) {
      return found;
    }
    for (const RawEntry& entry : raw_entries(text))
      for (const std::string& word : entry.words) found.emplace(key_of_words(word), entry.words.front());
    return found;
  }();
  return terms;
}

TextBlock read_definition(const RawEntry& entry, const std::string& file) {
  StepText text = read_markdown(entry.text, file, entry.line + 1);
  if (text.blocks.size() != 1 || !text.hints.empty() || text.blocks.front().kind != BlockKind::paragraph)
    throw InputError({file, entry.line, 1},
                     fmt::format("'{}' with {} paragraphs", entry.words.front(), text.blocks.size()),
                     "one paragraph, its definition");
  if (!text.step_links.empty()) throw InputError(text.step_links.front().place, "a link to a step", "lesson:FOLDER/N");
  return std::move(text.blocks.front());
}

}  // namespace

std::vector<GlossaryEntry> parse_glossary(std::string_view text, const std::string& file) {
  std::vector<GlossaryEntry> entries;
  std::map<std::string, std::string> seen;
  for (const RawEntry& raw : raw_entries(text)) {
    const SourcePlace place{file, raw.line, static_cast<int>(entry_mark.size()) + 1};
    if (raw.words.empty()) throw InputError(place, "no term", "## term; other forms");
    const std::string& term = raw.words.front();
    if (!entries.empty() && in_lower_case(entries.back().term) >= in_lower_case(term))
      throw InputError(place, fmt::format("'{}' behind '{}'", term, entries.back().term), "terms in order");
    for (const std::string& word : raw.words)
      if (const auto [other, is_new] = seen.emplace(key_of_words(word), term); !is_new)
        throw InputError(place, fmt::format("'{}' for a second time", word),
                         fmt::format("it under '{}' alone", other->second));
    entries.push_back({term, {raw.words.begin() + 1, raw.words.end()}, read_definition(raw, file)});
  }
  return entries;
}

const std::vector<GlossaryEntry>& glossary() {
  static const std::vector<GlossaryEntry> entries =
      parse_glossary(read_whole_file(glossary_file(), largest_glossary), glossary_file().string());
  return entries;
}

const GlossaryEntry* find_entry(std::string_view words) {
  const std::string term = term_of(words);
  if (term.empty()) return nullptr;
  const auto& entries = glossary();
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const auto& each) { return each.term == term; });
  return found == entries.end() ? nullptr : &*found;
}

std::string term_of(std::string_view words) {
  const auto& terms = terms_of_words();
  const auto found = terms.find(key_of_words(words));
  return found == terms.end() ? std::string() : found->second;
}

std::vector<std::string_view> glossary_terms() {
  std::vector<std::string_view> terms;
  for (const auto& [word, term] : terms_of_words())
    if (word == key_of_words(term)) terms.push_back(term);
  return terms;
}

}  // namespace ps
