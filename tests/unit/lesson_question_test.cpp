// Questions of lessons: how they are read, that the right answer is the measured one, and what makes a question bad.
#include "engine/question.h"

#include <gtest/gtest.h>

#include "engine/lesson.h"
#include "support/refusal.h"

namespace ps::lesson_question_test {
namespace {

/// A lesson whose first step asks this.
std::string lesson_with(const std::string& question) {
  return "# T\nsource: s\n\n## One\n\n```settings\nscene cgfs/spheres\nset-both renderer=ray-tracer\nsize 60x60\n"
         "pixel 30,40\n```\n\n```question\n" +
         question + "```\n";
}
constexpr int first_line = 14;  // of the question's own lines

LessonQuestion question_of(const std::string& question) {
  const Lesson lesson = parse_lesson(lesson_with(question), "demo", "lesson.md");
  return lesson.steps.at(0).question.value();
}

std::string error_of(const std::string& question) {
  return test::refusal_of([&] { question_of(question); });
}

MeasuredAnswer measured(const LessonQuestion& question) {
  Progress progress;
  return measure_answer(question, progress);
}

/// The objection of check_question(), or "".
std::string objection(const std::string& question) {
  Progress progress;
  std::string found;
  return check_question(question_of(question), progress, found);
}

const std::string choice =
    "ask choice\ntext How red is the pixel?\nmetric red-a\n"
    "choice = 0: Not at all. | The ray meets the red sphere.\n"
    "choice = 255: As red as can be. | Nothing dims it.\n"
    "choice = 51: A fifth. | No light is evaluated here.\nwhy There is no light in this scene.\nhide a\n";

TEST(LessonQuestion, AChoiceIsJudgedByWhatIsMeasured) {
  const LessonQuestion question = question_of(choice);
  EXPECT_EQ(ask_text(question), "choice");
  EXPECT_EQ(question.text, "How red is the pixel?");
  ASSERT_EQ(question.choices.size(), 3u);
  EXPECT_EQ(question.choices[1].text, "As red as can be.");
  EXPECT_EQ(question.hidden, (std::array{true, false}));
  const MeasuredAnswer right = measured(question);
  EXPECT_EQ(right.value, 255);  // the sphere's colour is pure red
  const Judgement good = judge(question, {.choice = 1}, right), bad = judge(question, {.choice = 0}, right);
  EXPECT_EQ(good.points, 1);
  EXPECT_EQ(good.sentence, "Right. Nothing dims it. There is no light in this scene.");
  EXPECT_EQ(bad.points, 0);
  EXPECT_EQ(bad.sentence, "The ray meets the red sphere. Right is: As red as can be. There is no light in this scene.");
  EXPECT_EQ(objection(choice), "");
}

TEST(LessonQuestion, TheSameChoiceIsWrongOnAnotherPixel) {
  const LessonQuestion question = question_of(choice + "pixel 0,0\n");  // white
  EXPECT_EQ(measured(question).value, 255);
  const LessonQuestion blue = question_of(choice + "pixel 50,30\n");
  EXPECT_EQ(measured(blue).value, 0);
  EXPECT_EQ(judge(blue, {.choice = 1}, measured(blue)).points, 0);
  EXPECT_EQ(judge(blue, {.choice = 0}, measured(blue)).points, 1);
}

TEST(LessonQuestion, ANumberHasAToleranceAndAUnit) {
  const LessonQuestion question =
      question_of("ask number\ntext How many eye rays has A?\nmetric counter-a eye-rays\ntolerance 36\nunit rays\n");
  const MeasuredAnswer right = measured(question);
  EXPECT_EQ(right.value, 60 * 60);
  EXPECT_EQ(judge(question, {.number = 3600}, right).points, 1);
  EXPECT_EQ(judge(question, {.number = 3636}, right).points, 1);
  EXPECT_EQ(judge(question, {.number = 3637}, right).points, 0);
  EXPECT_EQ(judge(question, {.number = 3600}, right).sentence, "Right: 3,600 rays.");
  EXPECT_EQ(judge(question, {.number = 1}, right).sentence, "It is 3,600 rays; you said 1 rays.");
}

TEST(LessonQuestion, LargeNumbersAreShownInFull) {
  const LessonQuestion question = question_of("ask number\ntext How many?\nmetric counter-a eye-rays\nsize 250x250\n");
  EXPECT_EQ(judge(question, {.number = 62500}, measured(question)).sentence, "Right: 62,500.");
}

TEST(LessonQuestion, AClickIsRightWhereTheBoundIsKept) {
  const LessonQuestion question =
      question_of("ask click\ntext Click the red sphere.\nmetric winner-a red\nbound = 1\nwhy It is red.\n");
  const MeasuredAnswer right = measured(question);
  ASSERT_EQ(right.places.width(), 60);
  EXPECT_EQ(judge(question, {.place = {30, 40}}, right).points, 1);
  EXPECT_EQ(judge(question, {.place = {30, 40}}, right).sentence, "Right. It is red.");
  EXPECT_EQ(judge(question, {.place = {0, 0}}, right).points, 0);
  EXPECT_EQ(judge(question, {.place = {0, 0}}, right).sentence, "Pixel (0, 0) is not such a place. It is red.");
  EXPECT_EQ(judge(question, {.place = {-1, 70}}, right).points, 0);
}

TEST(LessonQuestion, EachKindOfPixelQuestionIsRead) {
  for (const std::string kind : {"colour", "winner", "rays", "triangle", "tests"}) {
    const LessonQuestion question = question_of("ask " + kind + "\ntext What?\n");
    EXPECT_EQ(question.kind, AskKind::pixel);
    EXPECT_EQ(ask_text(question), kind);
  }
  EXPECT_EQ(objection("ask winner\ntext What?\n"), "");
  EXPECT_EQ(objection("ask tests\ntext How many?\n"), "");
  EXPECT_NE(objection("ask rays\ntext How many?\nset-both renderer=rasterizer\n"), "");
}

TEST(LessonQuestion, FaultsAreNamedWithTheirLine) {
  struct Fault {
    std::string question;
    int line;  ///< from the question's first, 0
    std::string message;
  };
  for (const Fault& fault :
       {Fault{"ask colours\ntext x\n", 0, "ask: found 'colours', expected choice, number, click"},
        Fault{"ask colour\ntext x\nfoo bar\n", 2, "found 'foo bar', expected ask, text, metric"},
        Fault{"ask number\ntext x\nmetric nothing\n", 2, "'nothing' is not a metric, expected one of differing-pixels"},
        Fault{"ask number\ntext x\nmetric psnr\ntolerance -1\n", 3, "tolerance: found '-1', expected a number from 0"},
        Fault{"ask choice\ntext x\nmetric psnr\nchoice > 3: y\nchoice = 1: z\n", 3,
              "expected >=, <= or = and a number"},
        Fault{"ask choice\ntext x\nmetric psnr\nchoice = 3 y\n", 3, "expected 'BOUND: ANSWER | SENTENCE'"},
        Fault{"ask number\ntext x\nmetric psnr\nhide c\n", 3, "hide: found 'c', expected a, b or both"},
        Fault{"text x\n", -1, "found a question about nothing"},
        Fault{"ask colour\n", -1, "found a question without words"},
        Fault{"ask number\ntext x\n", -1, "a question with 'ask number' without a line 'metric'"},
        Fault{"ask click\ntext x\nmetric red-a\n", -1, "without a line 'bound'"},
        Fault{"ask choice\ntext x\nmetric red-a\nchoice = 1: y\n", -1, "found a single choice, expected two or more"},
        Fault{"ask colour\ntext x\nmetric red-a\n", -1, "with a line 'metric', expected none"},
        Fault{"ask click\ntext x\nmetric red-a\nbound = 1\ntolerance 1\n", -1, "with a line 'tolerance'"},
        Fault{"ask number\ntext x\nmetric counter-a eye-rays\nwithin 0,0,3,3\n", -1, "is not measured on a part"}}) {
    const std::string error = error_of(fault.question);
    EXPECT_EQ(error.find("lesson.md:" + std::to_string(first_line + fault.line) + ":"), 0u) << error;
    EXPECT_NE(error.find(fault.message), std::string::npos) << error << "\nexpected " << fault.message;
  }
}

TEST(LessonQuestion, TheCheckFindsBadQuestions) {
  EXPECT_EQ(objection("ask choice\ntext x\nmetric red-a\nchoice = 1: y | n\nchoice = 2: z | n\n"),
            "no choices are right");
  EXPECT_EQ(objection("ask choice\ntext x\nmetric red-a\nchoice = 255: y\nchoice >= 2: z\n"),
            "several choices are right");
  EXPECT_EQ(objection("ask choice\ntext x\nmetric red-a\nchoice = 255: y\nchoice = 2: z\n"),
            "the wrong choice 'z' has no sentence");
  EXPECT_EQ(objection("ask click\ntext x\nmetric winner-a red\nbound = 2\n"), "no pixel is right");
  EXPECT_EQ(objection("ask click\ntext x\nmetric red-a\nbound >= 0\n"), "more than half of the pixels are right");
  EXPECT_EQ(objection("ask number\ntext x\nmetric psnr\nset-both renderer=ray-tracer\n"),
            "the answer is not a finite number");
}

}  // namespace
}  // namespace ps::lesson_question_test
