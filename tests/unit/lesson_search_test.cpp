// The search in all lessons: what is found, in which order, and what is said where nothing is.
#include <gtest/gtest.h>

#include "engine/lesson_search.h"

namespace ps::lesson_search_test {
namespace {

TextBlock paragraph(const std::string& text) { return {BlockKind::paragraph, 0, {{text}}}; }

LessonStep step(const std::string& title, const std::string& text) {
  LessonStep made;
  made.title = title;
  made.blocks.push_back(paragraph(text));
  return made;
}

Lesson lesson(const std::string& title, std::vector<LessonStep> steps) {
  Lesson made;
  made.title = title;
  made.source = "a book";
  made.steps = std::move(steps);
  return made;
}

/// In the order of a course that is the reverse of every rank below.
LessonIndex index() {
  LessonIndex made;
  made.add(lesson("Textures", {step("Lookup", "An array holds the gray texels."),
                               step("Smooth", "A mirror shows them. The light of a lamp is warm.")}));
  made.add(lesson("Reflection", {step("Copper mirrors", "Rays leave the surface."),
                                 step("A ray again", "Each bounce costs the shadow rays of one more point.")}));
  made.add(lesson("Mirrors and shadows", {step("One bounce", "The surface's own colour."),
                                          step("Epsilon", "Acne: the point is in shadow, which the bias cures.")}));
  return made;
}

/// "lesson/step place" of each.
std::vector<std::string> found(const LessonHits& hits) {
  constexpr const char* places[]{"title", "heading", "text"};
  std::vector<std::string> all;
  for (const LessonHit& hit : hits.hits)
    all.push_back(std::to_string(hit.lesson) + "/" + std::to_string(hit.step) + " " +
                  places[static_cast<int>(hit.place)]);
  return all;
}
std::vector<std::string> found(const std::string& query) { return found(index().find(query)); }
using Places = std::vector<std::string>;

// Fails where the order of the course decides, and where the ranks of two places change places.
TEST(LessonSearch, TitlesComeBeforeHeadingsAndTheseBeforeTexts) {
  EXPECT_EQ(found("mirror"), (Places{"2/0 title", "1/0 heading", "0/1 text"}));
}

// "array" and "gray" have the letters, in an earlier lesson.
TEST(LessonSearch, WholeWordsComeBeforePartsOfWords) {
  EXPECT_EQ(found("ray"), (Places{"1/1 heading", "1/0 text", "0/0 text"}));
}

TEST(LessonSearch, ThePhraseComesBeforeItsWords) {
  LessonIndex two;
  two.add(lesson("A", {step("S", "Rays of light meet a shadow.")}));
  two.add(lesson("B", {step("S", "It casts shadow rays.")}));
  EXPECT_EQ(found(two.find("shadow rays")), (Places{"1/0 text", "0/0 text"}));
}

TEST(LessonSearch, EachWordIsNeededInAnyOrderAndCase) {
  EXPECT_EQ(found("BIAS epsilon"), (Places{"2/1 text"}));
  EXPECT_EQ(found("reflection  bounce "), (Places{"1/1 text"})) << "title and text together";
  EXPECT_EQ(found("copper bias"), Places{}) << "in different steps";
  EXPECT_EQ(found(" "), Places{});
}

TEST(LessonSearch, ATextIsShownAroundItsMarkedWords) {
  LessonIndex one;
  std::string before, behind;
  for (int i = 0; i < 60; ++i) before += "before ", behind += " behind";
  one.add(lesson("A", {step("S", before + "the Shadow of α" + behind)}));
  const auto hits = one.find("α shadow").hits;
  ASSERT_EQ(hits.size(), 1u);
  const LessonHit& hit = hits.front();
  EXPECT_LT(hit.around.size(), 130u);
  EXPECT_EQ(hit.around.rfind("… before ", 0), 0u) << hit.around;
  EXPECT_NE(hit.around.find(" behind …"), std::string::npos) << hit.around;
  ASSERT_EQ(hit.marked.size(), 2u);
  const auto text = [&](const TextRange& range) { return hit.around.substr(range.begin, range.end - range.begin); };
  EXPECT_EQ(text(hit.marked[0]), "Shadow");
  EXPECT_EQ(text(hit.marked[1]), "α");
}

TEST(LessonSearch, WrongAndMissingLettersAreForgivenWhereNothingHasTheWords) {
  const auto typed = index().find("refelction");
  EXPECT_EQ(found(typed), (Places{"1/0 title"}));
  EXPECT_EQ(typed.alike, (std::vector<std::string>{"reflection"}));
  EXPECT_EQ(index().find("epsln").alike, (std::vector<std::string>{"epsilon"}));
  // "right" has one letter else than "light", and is not meant by who finds that.
  LessonIndex two;
  two.add(lesson("Right angles", {step("S", "A text.")}));
  two.add(lesson("B", {step("S", "The light.")}));
  EXPECT_EQ(found(two.find("light")), (Places{"1/0 text"}));
  EXPECT_TRUE(two.find("light").alike.empty());
}

TEST(LessonSearch, WithoutAHitTheNearestWordIsNamed) {
  const auto hits = index().find("mirror telescopes");
  EXPECT_TRUE(hits.hits.empty());
  EXPECT_EQ(hits.unknown, "telescopes");
  EXPECT_EQ(hits.nearest, "texels");
  const auto apart = index().find("copper bias");
  EXPECT_TRUE(apart.hits.empty() && apart.unknown.empty() && apart.alike.empty());
}

TEST(LessonSearch, WhatComesAfterAnAnswerIsNotFound) {
  LessonStep open = step("S", "A text."), asks = open;
  for (LessonStep* one : {&open, &asks}) {
    one->hints.push_back(paragraph("The hint."));
    one->claims.emplace_back().text = "The claim.";
  }
  asks.question.emplace().text = "The question?";
  asks.question->why = "The explanation.";
  LessonIndex two;
  two.add(lesson("A", {open, asks}));
  EXPECT_EQ(found(two.find("hint")), (Places{"0/0 text"}));
  EXPECT_EQ(found(two.find("claim")), (Places{"0/0 text"}));
  EXPECT_EQ(found(two.find("question")), (Places{"0/1 text"}));
  EXPECT_EQ(found(two.find("explanation")), Places{});
}

}  // namespace
}  // namespace ps::lesson_search_test
