// Answers of students: kept, read back, exported as a table that a spreadsheet reads without running anything.
#include "engine/answers.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include "base/check.h"
#include "base/file_lock.h"
#include "base/read_file.h"
#include "support/environment.h"
#include "support/run_cli.h"

namespace ps::lesson_answers_test {
namespace {

GivenAnswer answer(const std::string& words) {
  return {"2026-11-25T07:12:00Z", "cgfs_03_light", 2, "Which \"colour\"?", words, 0.5};
}

TEST(LessonAnswers, AreKeptAndReadBack) {
  const test::ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "new" / "answers.jsonl";
  EXPECT_TRUE(kept_answers(file).answers.empty());
  keep_answer(file, answer("51 0 0"));
  keep_answer(file, answer("a \"quoted\" line\nand ünother"));
  const auto kept = kept_answers(file).answers;
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0].time, "2026-11-25T07:12:00Z");
  EXPECT_EQ(kept[0].lesson, "cgfs_03_light");
  EXPECT_EQ(kept[0].step, 2);
  EXPECT_EQ(kept[0].question, "Which \"colour\"?");
  EXPECT_EQ(kept[0].answer, "51 0 0");
  EXPECT_EQ(kept[0].points, 0.5);
  EXPECT_EQ(kept[1].answer, "a \"quoted\" line\nand ünother");
}

TEST(LessonAnswers, ADamagedLineIsNamedAndSkipped) {
  const test::ScratchFolder folder;
  const std::string rest = "\"lesson\":\"l\",\"question\":\"q\",\"answer\":\"a\"";
  for (const std::string& bad :
       {std::string("{\"time\":"), std::string("[]"), std::string("{}"), std::string("{\"time\":1,\"lesson\":2}"),
        std::string("\xff\xfe"), "{\"time\":\"t\",\"step\":1e300,\"points\":1," + rest + "}",
        "{\"time\":\"t\",\"step\":-1,\"points\":1," + rest + "}",
        "{\"time\":\"t\",\"step\":99999999999,\"points\":1," + rest + "}",
        "{\"time\":\"t\",\"step\":1,\"points\":1e9," + rest + "}"}) {
    const std::filesystem::path file = folder.path() / "answers.jsonl";
    std::filesystem::remove(file);
    keep_answer(file, answer("one"));
    std::ofstream(file, std::ios::app) << "\n" << bad;  // the writer died before the line's end
    keep_answer(file, answer("two"));
    const KeptAnswers kept = kept_answers(file);
    ASSERT_EQ(kept.damaged.size(), 1u) << bad;
    EXPECT_EQ(kept.damaged[0].find(file.string() + ":3:1:"), 0u) << kept.damaged[0];
    ASSERT_EQ(kept.answers.size(), 2u) << bad;
    EXPECT_EQ(kept.answers[1].answer, "two");
  }
}

TEST(LessonAnswers, NoneIsLostWhereSeveralAreAddedAtOnce) {
  constexpr int writers = 4, each = 8;
  const test::ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "answers.jsonl";
  std::vector<std::thread> threads;
  threads.reserve(writers);
  for (int writer = 0; writer < writers; ++writer)
    threads.emplace_back([&file] {
      for (int i = 0; i < each;) try {
          keep_answer(file, answer("it"));
          ++i;
        } catch (const InputError&) {
          // The others had the file for too long, which is said. None of their answers is lost.
        }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(kept_answers(file).answers.size(), static_cast<std::size_t>(writers * each));
}

TEST(LessonAnswers, AFileThatAnotherProgramHoldsIsLeftAsItIs) {
  const test::ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "answers.jsonl";
  keep_answer(file, answer("one"));
  const auto lock = FileLock::try_lock(folder.file("answers.jsonl.lock"));
  ASSERT_TRUE(lock);
  EXPECT_THROW(keep_answer(file, answer("two")), InputError);
  EXPECT_EQ(kept_answers(file).answers.size(), 1u);
}

TEST(LessonAnswers, ARelativeStateFolderDoesNotCount) {
  const test::ScratchFolder home;
  const test::Variable state("XDG_STATE_HOME", "somewhere"), user("HOME", home.path().string());
  EXPECT_EQ(answers_file(), home.path() / ".local/state/pixelscope/answers.jsonl");
  const test::Variable relative("HOME", "elsewhere");
  EXPECT_EQ(answers_file(), "");
}

TEST(LessonAnswers, NothingOfTheTableIsAFormula) {
  for (const std::string formula : {"=1+1", "+x", "-2+3", "@SUM(A1)", "\t=1", "\r=1"}) {
    const std::string table = answers_csv({answer(formula)}, formula);
    EXPECT_NE(table.find("'" + formula), std::string::npos) << table;
    EXPECT_EQ(table.find("\n" + formula), std::string::npos) << table;
    EXPECT_EQ(table.find("," + formula), std::string::npos) << table;
  }
  EXPECT_NE(answers_csv({answer("-3")}, "Ada").find(",-3,"), std::string::npos);  // a number is none
}

TEST(LessonAnswers, TheTableHasARowForEach) {
  EXPECT_EQ(answers_csv({answer("51, 0"), answer("it")}, "Ada"),
            "student,time,lesson,step,question,answer,points\n"
            "Ada,2026-11-25T07:12:00Z,cgfs_03_light,3,\"Which \"\"colour\"\"?\",\"51, 0\",0.5\n"
            "Ada,2026-11-25T07:12:00Z,cgfs_03_light,3,\"Which \"\"colour\"\"?\",it,0.5\n");
}

TEST(LessonAnswers, TheCommandExportsThem) {
  const test::ScratchFolder folder;
  const test::Variable state("XDG_STATE_HOME", folder.path().string());
  EXPECT_EQ(answers_file(), folder.path() / "pixelscope" / "answers.jsonl");
  keep_answer(answers_file(), answer("it"));
  const auto printed = test::run_cli({"lessons", "answers", "--name", "Ada"});
  const auto written = test::run_cli({"lessons", "answers", "--name", "Ada", "--out", folder.file("table.csv")});
  std::ofstream(answers_file(), std::ios::app) << "no answer\n";
  const auto damaged = test::run_cli({"lessons", "answers", "--name", "Ada"});
  EXPECT_EQ(printed.status, 0) << printed.err;
  EXPECT_EQ(printed.out, answers_csv({answer("it")}, "Ada"));
  EXPECT_EQ(written.status, 0) << written.err;
  EXPECT_EQ(read_whole_file(folder.file("table.csv")), printed.out);
  EXPECT_EQ(damaged.status, 1);
  EXPECT_EQ(damaged.out, printed.out);
  EXPECT_NE(damaged.err.find("answers.jsonl:2:1"), std::string::npos) << damaged.err;
}

}  // namespace
}  // namespace ps::lesson_answers_test
