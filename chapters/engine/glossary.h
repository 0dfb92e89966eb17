#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "engine/text.h"

namespace ps {

/// A term of the field with its definition, as chapters/glossary.md has it: "## term; other forms" and a sentence.
struct GlossaryEntry {
  std::string term;
  std::vector<std::string> forms;  ///< other words for it: plurals, abbreviations
  TextBlock definition;            ///< one sentence
};

/// All terms in the order of the alphabet. Throws InputError when the file is missing or faulty.
const std::vector<GlossaryEntry>& glossary();

/// The entry of a term or one of its forms, in whatever case and with hyphens for blanks; nullptr for other words.
const GlossaryEntry* find_entry(std::string_view words);

/// The term that these words are a form of, without reading definitions; empty for other words, and where there is no
/// glossary.
std::string term_of(std::string_view words);

/// All terms, for messages.
std::vector<std::string_view> glossary_terms();

/// Reads the text of a glossary.md; `file` is only for messages. Throws InputError with file, line and column for a
/// term without a definition, a second definition, a form that is there twice, and terms out of order.
std::vector<GlossaryEntry> parse_glossary(std::string_view text, const std::string& file);

}  // namespace ps
