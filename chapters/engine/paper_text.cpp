#include "engine/paper_text.h"

#include <algorithm>
#include <regex>

namespace ps {
namespace {

/// The place after the first sentence that ends in this text; its size if none does.
std::size_t end_of_sentence(const std::string& text) {
  for (std::size_t i = 0; i + 1 < text.size(); ++i)
    if ((text[i] == '.' || text[i] == '?' || text[i] == '!') && text[i + 1] == ' ') return i + 2;
  return text.size();
}

std::string words_of(const Sentence& sentence) {
  std::string words;
  for (const TextSpan& span : sentence) words += span.text;
  return words;
}

bool names_a_key(const TextSpan& span) {
  return span.style == TextStyle::code && span.text.size() == 1 && !span.formula;
}

/// Is it about a key, a click or a drag?
bool needs_the_window(const Sentence& sentence) {
  static const std::regex deeds(R"(\b([Pp]ress|[Cc]lick|[Dd]rag|Ctrl|[Ww]heel|arrow keys?|space bar|scrubber)\b)"
                                R"(|\b[Pp]ress(es)? |\bhold [A-Z]\b|^[A-Z] shows)");
  return std::any_of(sentence.begin(), sentence.end(), names_a_key) || std::regex_search(words_of(sentence), deeds);
}

/// "Set" alone needs the name of the control behind it; "Raise the depth" has named it.
bool stands_for_a_name(const std::string& before) {
  const auto words = std::count(before.begin(), before.end(), ' ');
  return words <= 1;
}

Sentence without_controls(const Sentence& sentence) {
  Sentence written;
  std::string before;
  for (const TextSpan& span : sentence) {
    if (span.link.kind == LinkKind::control && !stands_for_a_name(before)) {
      if (!written.empty() && !written.back().text.empty() && written.back().text.back() == ' ')
        written.back().text.pop_back();
      continue;
    }
    written.push_back(span);
    before += span.text;
  }
  return written;
}

}  // namespace

std::vector<Sentence> sentences_of(const TextBlock& block) {
  std::vector<Sentence> sentences(1);
  for (const TextSpan& span : block.spans) {
    if (span.formula || span.style == TextStyle::code) {
      sentences.back().push_back(span);
      continue;
    }
    for (std::string rest = span.text; !rest.empty();) {
      const std::size_t end = end_of_sentence(rest);
      TextSpan part = span;
      part.text = rest.substr(0, end);
      sentences.back().push_back(part);
      const bool ended = end < rest.size() || (end >= 2 && rest[end - 1] == ' ' && std::ispunct(rest[end - 2]) != 0 &&
                                               rest[end - 2] != ',' && rest[end - 2] != ':');
      rest.erase(0, end);
      if (ended) sentences.emplace_back();
    }
  }
  return sentences;
}

std::vector<TextBlock> on_paper(const std::vector<TextBlock>& blocks) {
  std::vector<TextBlock> paper;
  for (const TextBlock& block : blocks) {
    TextBlock printed = block;
    printed.spans.clear();
    for (const Sentence& sentence : sentences_of(block)) {
      if (needs_the_window(sentence)) continue;
      const Sentence written = without_controls(sentence);
      printed.spans.insert(printed.spans.end(), written.begin(), written.end());
    }
    if (!printed.spans.empty()) paper.push_back(std::move(printed));
  }
  return paper;
}

std::vector<TextBlock> hints_on_paper(const std::vector<TextBlock>& hints) {
  std::vector<TextBlock> kept;
  for (const TextBlock& hint : hints) {
    const auto sentences = sentences_of(hint);
    if (std::none_of(sentences.begin(), sentences.end(), needs_the_window)) kept.push_back(hint);
  }
  return on_paper(kept);
}

std::string question_on_paper(std::string text) {
  const std::string click = "Click ";
  for (auto at = text.find(click); at != std::string::npos; at = text.find(click, at))
    text.replace(at, click.size(), "Mark ");
  return text;
}

}  // namespace ps
