#pragma once
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/lesson.h"

namespace ps {

/// Where in a lesson a search found its words, best first.
enum class HitPlace { title, heading, text };

/// Bytes of a text from `begin` to the one before `end`.
struct TextRange {
  std::size_t begin = 0, end = 0;
};

/// A lesson, or a step of one, that has all words of a query.
struct LessonHit {
  std::size_t lesson = 0;  ///< its number in the index
  int step = 0;            ///< from 0; the first one if the lesson's title has the words
  HitPlace place = HitPlace::title;
  std::string around;             ///< the text around the first word found, else its beginning; in one line
  std::vector<TextRange> marked;  ///< the words of the query in `around`, in their order there
};

/// The result of a search.
struct LessonHits {
  std::vector<LessonHit> hits;  ///< best first
  std::vector<std::string>
      alike;                     ///< not empty: no lesson has the words as typed, and these were sought in their place
  std::string unknown, nearest;  ///< a word of the query that no lesson has, and the most similar word of a lesson
};

/// The words of all lessons, for a search while a query is typed.
class LessonIndex {
 public:
  /// Lessons have the numbers 0, 1, ... in the order in which they are added. Texts that a step shows only after the
  /// answer to its question (hints, claims) are left out, so that no search gives the answer away.
  void add(const Lesson& lesson);

  /// The lessons and steps that have each word of the query, whatever its order and case, also within longer words.
  /// Titles come before headings of steps, and these before texts; in each, the query in one piece comes before whole
  /// words, and these before parts of words; then the order of the course decides. If there is none, similar words are
  /// sought: with a few wrong letters, or with letters left out. An empty query has no result.
  LessonHits find(std::string_view query) const;

 private:
  struct Text {
    std::string shown, small;  ///< as it is written, and in small letters
  };
  struct Step {
    Text heading, text;
  };
  struct Entry {
    Text title;
    std::vector<Step> steps;
  };
  struct Sought;
  static Text searchable(std::string_view text);
  std::vector<LessonHit> hits_of(const std::vector<Sought>& sought, const Sought& phrase) const;
  std::vector<std::string> words_alike(std::string_view word) const;
  bool occurs(const Sought& sought) const;

  std::vector<Entry> lessons_;
  std::set<std::string> words_;  ///< of all texts, in small letters
};

}  // namespace ps
