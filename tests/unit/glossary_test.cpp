// The glossary: every entry can be read, every link in it leads somewhere, and faults are named with their place.
#include "engine/glossary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/lesson.h"
#include "support/refusal.h"

namespace ps::glossary_test {
namespace {

std::string error_of(const std::string& text) {
  return test::refusal_of([&] { parse_glossary(text, "glossary.md"); });
}

TEST(Glossary, HasOneSentenceForEachTerm) {
  ASSERT_GT(glossary().size(), 80u);
  for (const GlossaryEntry& entry : glossary()) {
    const std::string text = plain_text(entry.definition);
    EXPECT_EQ(text.back(), '.') << entry.term << ": " << text;
    EXPECT_EQ(text.find(". "), std::string::npos) << entry.term << ": more than one sentence";
    EXPECT_EQ(find_entry(entry.term), &entry);
    for (const std::string& form : entry.forms) EXPECT_EQ(find_entry(form), &entry) << form;
  }
}

/// Of all lessons and definitions: none names a term that is not there. Reading them would throw, but for a glossary
/// that cannot be read at all.
TEST(Glossary, EveryLinkToATermResolves) {
  std::set<std::string> linked;
  const auto collect = [&](const std::vector<TextBlock>& blocks) {
    for (const TextBlock& block : blocks)
      for (const TextSpan& span : block.spans)
        if (span.link.kind == LinkKind::term) {
          EXPECT_NE(find_entry(span.link.target), nullptr) << span.link.target;
          linked.insert(span.link.target);
        }
  };
  for (const std::string& name : lesson_names()) {
    const Lesson lesson = load_lesson(name);
    collect(lesson.blocks);
    for (const LessonStep& step : lesson.steps) {
      collect(step.blocks);
      collect(step.hints);
    }
  }
  for (const GlossaryEntry& entry : glossary()) collect({entry.definition});
  EXPECT_GT(linked.size(), 10u);
}

TEST(Glossary, FindsTermsInAnyCaseAndForm) {
  EXPECT_EQ(term_of("Vertices"), "vertex");
  EXPECT_EQ(term_of("dot-product"), "dot product");
  EXPECT_EQ(term_of("back face culling"), "back-face culling");
  EXPECT_EQ(term_of("no such term"), "");
  EXPECT_EQ(find_entry("no such term"), nullptr);
  const auto terms = glossary_terms();
  EXPECT_NE(std::find(terms.begin(), terms.end(), "vertex"), terms.end());
  EXPECT_EQ(std::find(terms.begin(), terms.end(), "vertices"), terms.end());
}

TEST(Glossary, NamesEachFaultWithItsPlace) {
  EXPECT_EQ(error_of("# Glossary\n\n## a; b\n\nOne.\n\n## c\n\nTwo $x$.\n"), "");
  EXPECT_EQ(error_of("## a\n\n## b\n\nTwo.\n"),
            "glossary.md:1:1: found 'a' with 0 paragraphs, expected one paragraph, its definition");
  EXPECT_EQ(error_of("## a\n\nOne.\n\nTwo.\n"),
            "glossary.md:1:1: found 'a' with 2 paragraphs, expected one paragraph, its definition");
  EXPECT_EQ(error_of("## b\n\nOne.\n\n## A\n\nTwo.\n"),
            "glossary.md:5:4: found 'A' behind 'b', expected terms in order");
  EXPECT_EQ(error_of("## a; c\n\nOne.\n\n## b; C\n\nTwo.\n"),
            "glossary.md:5:4: found 'C' for a second time, expected it under 'a' alone");
  EXPECT_EQ(error_of("## ;\n\nOne.\n"), "glossary.md:1:4: found no term, expected ## term; other forms");
  EXPECT_EQ(error_of("## a\n\nOne [b](step:1).\n").substr(0, 16), "glossary.md:3:5:");
  EXPECT_EQ(error_of("## a\n\nOne $\\x$.\n").substr(0, 48), "glossary.md:3:6: found the unknown command '\\x',");
}

}  // namespace
}  // namespace ps::glossary_test
