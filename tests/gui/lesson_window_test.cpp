// Lessons in the window: answers are there after a restart, and a folder of one's own is read again when it is saved.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "gui/platform/state_file.h"
#include "gui/program.h"
#include "support/golden.h"

namespace lesson_window_test {
namespace {

namespace fs = std::filesystem;

fs::path state_folder(const std::string& name) {
  fs::path folder = fs::absolute(ps::fresh_output_folder("gui-lesson-" + name));
  fs::create_directories(folder / "pixelscope");
  return folder;
}

/// Plays commands in a window that remembers its state in this folder.
void plays(const fs::path& state, const std::string& commands, const std::string& lesson) {
  std::ofstream(state / "play.script") << "wait idle\n" + commands + "quit\n";
  const auto run = ps::test::run_window("--script " + (state / "play.script").string() +
                                            " --window-size 1366x768 --lesson " + lesson,
                                        "timeout 150 env XDG_STATE_HOME=" + state.string());
  EXPECT_EQ(run.status, 0) << run.errors;
}

TEST(LessonWindow, AnswersAreThereAfterARestart) {
  const fs::path state = state_folder("answers");
  const std::string lesson = "tests/gui/files/questions";
  plays(state,
        "click question/choice/1\nwait frames 3\nclick question/answer\nwait idle\nexpect question/points 0\n"
        "key Shift+PageDown\nwait idle\nclick question/skip\nwait idle\n",
        lesson);
  plays(state,
        "expect question/open off\nexpect question/verdict contains \"You answered: One for each pixel\"\n"
        "expect question/verdict contains \"That was not right.\"\n"
        // What was skipped is asked again.
        "key Shift+PageDown\nwait idle\nexpect question/open on\nclick question/number\ntype 57600\nkey Enter\n"
        "wait idle\nexpect question/points 1\n",
        lesson);
  plays(state, "expect question/open off\nclick lesson/ask-again\nwait idle\nexpect question/open on\n", lesson + "/2");
  std::ofstream(state / "pixelscope" / "answers.jsonl", std::ios::app) << "{\"damaged\"\n";
  plays(state, "expect question/open off\nexpect message contains \"answers.jsonl:3:1\"\n", lesson);
}

std::string lesson_text(const std::string& title, const std::string& settings) {
  return "# " + title + "\\nsource: s\\n\\n## Only\\n\\n```settings\\nscene cgfs/spheres\\nsize 60x60\\n" + settings +
         "```\\n";
}

TEST(LessonWindow, AFolderOfOnesOwnIsReadAgainWhenItIsSaved) {
  const fs::path state = state_folder("own"), own = state / "mine", other = state / "other";
  fs::create_directories(own);
  fs::copy("tests/gui/files/questions", own, fs::copy_options::recursive);
  fs::copy(own, other);
  const std::string file = (own / "lesson.md").string();
  plays(state,
        "expect lesson " + own.string() + "\nexpect step 3\n" +  //
            "write " + file + " \"" + lesson_text("New", "set exposure=0.5\\n") + "\"\n" +
            "wait until lesson/place contains \"step 1 of 1\"\nwait idle\nexpect permalink contains exposure=0.5\n" +
            // An error names its place, and what was there stays.
            "write " + file + " \"" + lesson_text("New", "set exposure=lots\\n") + "\"\n" +
            "wait until message contains \"lesson.md:9\"\nexpect message contains lots\n" +
            "expect lesson/place contains \"step 1 of 1\"\n" + "write " + file + " \"" +
            lesson_text("New", "set exposure=0.25\\n") + "\"\n" +
            "wait until permalink contains exposure=0.25\nwait until messages 0\n" +
            // A folder can be dropped.
            "drop " + other.string() + "\nwait until lesson " + other.string() + "\nwait idle\nexpect step 1\n",
        own.string() + "/3");
  const ps::gui::StateFile remembered(state / "pixelscope" / "window.json");
  const std::string recent = remembered.get("session/recent");
  EXPECT_NE(recent.find(own.string()), std::string::npos) << recent;
  EXPECT_NE(recent.find(other.string()), std::string::npos) << recent;
}

/// Everything fits, in every state of the questions and of the claims. `pages`: of the text of the answered first step,
/// on the last of which the first claim is.
void expect_questions_fit(const std::string& screen, const std::string& type, int pages) {
  const std::string fits = "wait frames 3\nexpect window/cut \"\"\nexpect window/overlap \"\"\n";
  std::string commands = "wait idle\n" + fits + "click question/choice/1\n" + fits +
                         "click question/answer\nwait idle\n" + fits + "expect lesson/pages " + std::to_string(pages) +
                         "\n";
  for (int page = 1; page < pages; ++page) commands += "key PageDown\n" + fits;
  commands += "wait until lesson/claim/0/state holds\n" + fits +
              "click lesson/claim/0/break\nwait idle\nwait until lesson/claim/0/state broken\n" + fits +
              "click lesson/claim/0/mend\nwait idle\n" + fits;
  for (const std::string& answer :
       {"click question/number\ntype 57,60\nkey Enter\n" + fits + "click question/skip\n",
        "click-pixel A 60,150\n" + fits + "click question/answer\n",
        "click-pixel A 60,150\n" + fits + "click question/back\nwait idle\n" + fits + "click predict/answer\n"})
    commands += "key Shift+PageDown\nwait idle\n" + fits + answer + "wait idle\n" + fits;
  const auto folder = ps::fresh_output_folder("gui-lesson-fit-" + screen + "-" + type);
  const auto run =
      ps::test::play(commands + "quit\n", folder, screen, "--scale " + type + " --lesson tests/gui/files/questions");
  EXPECT_EQ(run.status, 0) << screen << " type " << type << ": " << run.errors;
}

TEST(LessonWindow, QuestionsAndClaimsFitSmallScreens) {
  expect_questions_fit("1024x768", "1", 1);
  expect_questions_fit("1366x768", "1", 1);
  expect_questions_fit("1024x768", "1.5", 2);
  expect_questions_fit("1366x768", "1.5", 2);
}

}  // namespace
}  // namespace lesson_window_test
