// Paper has no keys: the sentences about them go, and no lesson's printed text is left with one.
#include "engine/paper_text.h"

#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "engine/lesson.h"
#include "engine/markdown.h"
#include "options/difference_words.h"

namespace ps::paper_text_test {
namespace {

std::string printed(const std::string& text) {
  std::string words;
  for (const TextBlock& block : on_paper(read_markdown(text, "lesson.md", 1).blocks)) words += plain_text(block) + "|";
  return words;
}

std::string printed_hints(const std::string& text) {
  std::string words;
  for (const TextBlock& block : hints_on_paper(read_markdown(text, "lesson.md", 1).hints))
    words += plain_text(block) + "|";
  return words;
}

TEST(PaperText, SentencesAboutKeysGo) {
  EXPECT_EQ(printed("A is red. Press `D`: only spots are left. B is *blue*.\n"), "A is red. B is blue.|");
  EXPECT_EQ(printed("Drag the light.\n\nIt is bright.\n"), "It is bright.|");
  EXPECT_EQ(printed("Which is larger? Turn it with Ctrl and the arrow keys.\n"), "Which is larger? |");
  EXPECT_EQ(printed("At $x = 0.5$ it is dark. Nobody sees it.\n"), "At x = 0.5 it is dark. Nobody sees it.|");
}

TEST(PaperText, AHintGoesAsAWhole) {
  EXPECT_EQ(printed_hints("> Press `D`: only spots are left. The wide one is of 10.\n\n> Look at the edge.\n"),
            "Look at the edge.|");
}

TEST(PaperText, ALiveControlIsNamedWhereNothingElseNamesIt) {
  EXPECT_EQ(printed("Raise the depth [[a.reflection-depth]] from 0.\n"), "Raise the depth from 0.|");
  EXPECT_EQ(printed("Set [[a.shadow-epsilon]] to 0.\n"), "Set Shadow epsilon to 0.|");
}

TEST(PaperText, QuestionsAskForAMark) {
  EXPECT_EQ(question_on_paper("It is far. Click a place in A."), "It is far. Mark a place in A.");
}

TEST(PaperText, NoLessonPrintsAKeyOrAClick) {
  const std::regex keys(R"(\b([Pp]ress|[Cc]lick|[Dd]rag|Ctrl|arrow key)\b)");
  std::size_t blocks = 0;
  for (const std::string& name : lesson_names()) {
    const Lesson lesson = load_lesson(name);
    const auto check = [&](const std::vector<TextBlock>& text) {
      for (const TextBlock& block : text) {
        ++blocks;
        EXPECT_FALSE(std::regex_search(plain_text(block), keys)) << name << ": " << plain_text(block);
      }
    };
    check(on_paper(lesson.blocks));
    for (const LessonStep& step : lesson.steps) {
      check(on_paper(step.blocks));
      check(hints_on_paper(step.hints));
      if (step.question) {
        EXPECT_EQ(question_on_paper(step.question->text).find("Click"), std::string::npos) << name;
      }
    }
  }
  EXPECT_GT(blocks, 500u) << "the texts are still there";
}

TEST(DifferenceWords, NameWhatTheOtherDoesNotHave) {
  Settings a, b;
  EXPECT_EQ(difference_words(a, b), "");
  a.renderer = Renderer::rasterizer;
  a.shading = Shading::flat;
  b.reflection_depth = 1;
  b.specular = false;
  EXPECT_EQ(difference_words(a, b), "rasterizer, shading: flat, with highlights, reflection depth 3");
  EXPECT_EQ(difference_words(b, a), "ray tracer, shading: Phong, without highlights, reflection depth 1");
}

TEST(DifferenceWords, AnAssignmentHasTheSameWords) {
  EXPECT_EQ(setting_words("shading=flat"), "shading: flat");
  EXPECT_EQ(setting_words("specular=off"), "without highlights");
  EXPECT_EQ(setting_words("reflection-depth=2"), "reflection depth 2");
  EXPECT_EQ(setting_words("shadows=none"), "without shadows");
  EXPECT_EQ(setting_words("shadows=map"), "shadows: shadow map");
  EXPECT_EQ(setting_words("reflection-depth=0"), "without reflections");
  EXPECT_EQ(setting_words("parallax-mapping=off"), "without parallax mapping");
  EXPECT_EQ(setting_words("camera-relative=off"), "in world coordinates");
  EXPECT_EQ(setting_words("camera-relative=on"), "relative to the camera");
  EXPECT_EQ(setting_words("shadow-any-hit=on"), "shadow rays stop at any hit");
  EXPECT_EQ(setting_words("renormalise=off"), "normals as interpolated");
  EXPECT_EQ(setting_words("accelerator=none"), "without an accelerator");
  EXPECT_EQ(setting_words("reflection-depth=many"), "reflection-depth=many") << "no such value";
  EXPECT_EQ(settings_in_words("double, shading=flat, specular=on"), "double, shading: flat, with highlights");
}

TEST(DifferenceWords, ABugIsNotNamed) {
  Settings a, b;
  a.listing_bug = 2;
  EXPECT_EQ(difference_words(a, b), "with the bug");
  EXPECT_EQ(difference_words(b, a), "without the bug");
}

}  // namespace
}  // namespace ps::paper_text_test
