#include "engine/lesson_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/spelling.h"
#include "base/word_search.h"
#include "engine/words_in_text.h"

namespace ps {

/// A word of the query, or the words that are sought in its place.
struct LessonIndex::Sought {
  std::vector<std::string> words;
  WordPart part = WordPart::any;

  std::optional<FoundWord> in(std::string_view small) const {
    std::optional<FoundWord> found;
    for (const std::string& word : words)
      if (const auto place = find_word(small, word, part); place && (!found || place->begins_word > found->begins_word))
        found = place;
    return found;
  }
};

namespace {

/// How a text has the words of a query, best first.
enum class Closeness { one_piece, words, parts_of_words };

void append_blocks(const std::vector<TextBlock>& blocks, std::string& text) {
  for (const TextBlock& block : blocks) text += plain_text(block) + ' ';
}

/// The texts of a step before its question, if it has one, is answered.
std::string shown_text(const LessonStep& step) {
  std::string text;
  append_blocks(step.blocks, text);
  if (step.question) return text + step.question->text;
  append_blocks(step.hints, text);
  for (const Claim& claim : step.claims) text += claim.text + ' ';
  return text;
}

std::vector<std::string> query_words(std::string_view small) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < small.size(); ++at) {
    const std::size_t end = std::min(small.find(' ', at), small.size());
    if (end > at) words.emplace_back(small.substr(at, end - at));
    at = end;
  }
  return words;
}

}  // namespace

LessonIndex::Text LessonIndex::searchable(std::string_view text) {
  std::string shown(text);
  std::replace(shown.begin(), shown.end(), '\n', ' ');
  while (!shown.empty() && shown.back() == ' ') shown.pop_back();
  return {shown, in_small_letters(shown)};
}

void LessonIndex::add(const Lesson& lesson) {
  Entry& entry = lessons_.emplace_back();
  entry.title = searchable(lesson.title + ", " + lesson.source);
  add_words(entry.title.small, words_);
  for (const LessonStep& step : lesson.steps) {
    std::string text;
    if (entry.steps.empty()) append_blocks(lesson.blocks, text);
    const Step& added = entry.steps.emplace_back(Step{searchable(step.title), searchable(text + shown_text(step))});
    add_words(added.heading.small, words_);
    add_words(added.text.small, words_);
  }
}

std::vector<LessonHit> LessonIndex::hits_of(const std::vector<Sought>& sought, const Sought& phrase) const {
  struct Ranked {
    LessonHit hit;
    Closeness closeness;
  };
  std::vector<Ranked> found;
  const auto all_of = [&](const auto& has) { return std::all_of(sought.begin(), sought.end(), has); };
  const auto closeness_in = [&](const Text& text) {
    if (const auto piece = phrase.in(text.small); piece && piece->begins_word) return Closeness::one_piece;
    const bool words = all_of([&](const Sought& one) {
      const auto place = one.in(text.small);
      return !place || place->begins_word;
    });
    return words ? Closeness::words : Closeness::parts_of_words;
  };
  for (std::size_t number = 0; number < lessons_.size(); ++number) {
    const Entry& lesson = lessons_[number];
    const auto in_title = [&](const Sought& one) { return one.in(lesson.title.small).has_value(); };
    if (all_of(in_title)) {
      const std::string begin = lesson.steps.empty() ? "" : text_around(lesson.steps.front().text.shown, {});
      found.push_back({{number, 0, HitPlace::title, begin, {}}, closeness_in(lesson.title)});
    }
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
      const Text &heading = lesson.steps[i].heading, &text = lesson.steps[i].text;
      const auto in_heading = [&heading](const Sought& one) { return one.in(heading.small).has_value(); };
      const auto in_text = [&text](const Sought& one) { return one.in(text.small).has_value(); };
      LessonHit hit{number, static_cast<int>(i), HitPlace::heading, text_around(text.shown, {}), {}};
      if (all_of([&](const Sought& one) { return in_title(one) || in_heading(one); }) &&
          std::any_of(sought.begin(), sought.end(), in_heading)) {
        found.push_back({std::move(hit), closeness_in(heading)});
        continue;
      }
      const auto first = std::find_if(sought.begin(), sought.end(), in_text);
      if (first == sought.end() ||
          !all_of([&](const Sought& one) { return in_title(one) || in_heading(one) || in_text(one); }))
        continue;
      hit.place = HitPlace::text;
      const auto piece = phrase.in(text.small);
      hit.around = text_around(text.shown, (piece ? piece : first->in(text.small))->range);
      for (const Sought& one : sought)
        if (const auto place = one.in(in_small_letters(hit.around))) hit.marked.push_back(place->range);
      std::sort(hit.marked.begin(), hit.marked.end(), [](TextRange a, TextRange b) { return a.begin < b.begin; });
      found.push_back({std::move(hit), closeness_in(text)});
    }
  }
  const auto rank = [](const Ranked& one) { return std::tuple(one.hit.place, one.closeness); };
  std::stable_sort(found.begin(), found.end(), [&](const Ranked& a, const Ranked& b) { return rank(a) < rank(b); });
  std::vector<LessonHit> hits;
  hits.reserve(found.size());
  for (Ranked& one : found) hits.push_back(std::move(one.hit));
  return hits;
}

std::vector<std::string> LessonIndex::words_alike(std::string_view word) const {
  constexpr std::size_t least_in_order = 3, least_letters = 4;  // shorter words are like nearly anything
  std::vector<std::string> alike;
  std::size_t best = (word.size() + 1) / 3;  // wrong letters, at most a third
  std::vector<std::string> nearest;
  for (const std::string& candidate : words_) {
    if (word.size() >= least_in_order && candidate.front() == word.front() && candidate.size() <= 2 * word.size() &&
        letters_in_order(word, candidate))
      alike.push_back(candidate);
    if (word.size() < least_letters || candidate.size() > word.size() + best || word.size() > candidate.size() + best)
      continue;
    const std::size_t distance = edit_distance(candidate, word);
    if (distance < best) nearest.clear();
    if (distance > best) continue;
    best = distance;
    nearest.push_back(candidate);
  }
  for (const std::string& one : nearest)
    if (std::find(alike.begin(), alike.end(), one) == alike.end()) alike.push_back(one);
  return alike;
}

bool LessonIndex::occurs(const Sought& sought) const {
  return std::any_of(lessons_.begin(), lessons_.end(), [&](const Entry& lesson) {
    return sought.in(lesson.title.small) ||
           std::any_of(lesson.steps.begin(), lesson.steps.end(),
                       [&](const Step& step) { return sought.in(step.heading.small) || sought.in(step.text.small); });
  });
}

LessonHits LessonIndex::find(std::string_view query) const {
  const std::vector<std::string> words = query_words(in_small_letters(query));
  LessonHits found;
  if (words.empty()) return found;
  std::vector<Sought> sought;
  sought.reserve(words.size());
  for (const std::string& word : words) sought.push_back({{word}, WordPart::any});
  const Sought phrase{{fmt::format("{}", fmt::join(words, " "))}, WordPart::any};
  found.hits = hits_of(sought, phrase);
  if (!found.hits.empty()) return found;
  std::vector<std::string> alike;
  for (Sought& one : sought) {
    if (occurs(one)) continue;
    const std::string word = one.words.front();
    one = {words_alike(word), WordPart::whole};
    if (one.words.empty()) {
      found.unknown = word;
      const std::vector<std::string_view> known(words_.begin(), words_.end());
      found.nearest = nearest_word(word, known);
      return found;
    }
    alike.insert(alike.end(), one.words.begin(), one.words.end());
  }
  if (alike.empty()) return found;
  found.hits = hits_of(sought, phrase);
  if (!found.hits.empty()) found.alike = std::move(alike);
  return found;
}

}  // namespace ps
