// Lessons in a folder of one's own: begun from a template, checked, and printed; what the check must not let through.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "base/read_file.h"
#include "base/resources.h"
#include "document/permalink.h"
#include "engine/handout.h"
#include "engine/lesson_place.h"
#include "image/file.h"
#include "support/lesson_demands.h"
#include "support/run_cli.h"
#include "support/well_formed.h"

namespace ps::lesson_folder_test {
namespace {
using test::run_cli;
using test::run_cli_well;
using test::ScratchFolder;

/// A folder with the template's lesson, in which `from` is replaced.
struct OwnLesson {
  explicit OwnLesson(const std::string& from = {}, const std::string& to = {}) {
    run_cli_well({"lessons", "new", path()});
    std::string text = read_whole_file(path() + "/lesson.md");
    if (!from.empty()) {
      const auto at = text.find(from);
      EXPECT_NE(at, std::string::npos) << from;
      text.replace(at, from.size(), to);
      std::ofstream(path() + "/lesson.md", std::ios::binary) << text;
    }
  }
  std::string path() const { return folder.file("mine"); }
  ScratchFolder folder;
};

TEST(LessonFolder, TheTemplatePassesTheCheck) {
  const OwnLesson lesson;
  const auto checked = run_cli({"lessons", "check", lesson.path()});
  EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
  EXPECT_TRUE(checked.out.ends_with("3 claims, 2 questions, 0 bugs checked, 0 failed\n")) << checked.out;
}

TEST(LessonFolder, TheTemplateHasWhatALessonNeeds) { test::expect_complete(load_lesson(OwnLesson().path())); }

TEST(LessonFolder, NothingThatIsThereIsOverwritten) {
  const OwnLesson lesson;
  const std::string before = read_whole_file(lesson.path() + "/lesson.md");
  const auto again = run_cli({"lessons", "new", lesson.path()});
  EXPECT_EQ(again.status, 2);
  EXPECT_NE(again.err.find("lesson.md exists already"), std::string::npos) << again.err;
  EXPECT_EQ(read_whole_file(lesson.path() + "/lesson.md"), before);
}

TEST(LessonFolder, TheCheckRefusesWhatIsNotTrue) {
  struct Case {
    std::string from, to, complaint;
  };
  for (const Case& each : {Case{"bound >= 20000", "bound >= 300000", "DOES NOT HOLD"},
                           Case{"mutation shadows", "mutation shadow-epsilon", "HOLDS WITH THE MUTATION TOO"},
                           Case{"choice = 0: None", "choice = 1: None", "NO: no choices are right"},
                           Case{"choice = 360000: One", "choice >= 0: One", "NO: several choices are right"},
                           Case{" | That would be the number of eye rays.", "", "has no sentence"},
                           Case{"size 300x200", "scene ./none.scene", "step 3 cannot be shown"}}) {
    const OwnLesson lesson(each.from, each.to);
    const auto checked = run_cli({"lessons", "check", lesson.path()});
    EXPECT_EQ(checked.status, 1) << each.to << checked.err;
    EXPECT_NE(checked.out.find(each.complaint), std::string::npos) << checked.out;
    EXPECT_TRUE(checked.out.ends_with(" 1 failed\n")) << checked.out;
  }
}

TEST(LessonFolder, TheQuickCheckMeasuresClaimsAsTheyStand) {
  const auto quick = [](const OwnLesson& lesson) { return run_cli({"lessons", "check", lesson.path(), "--quick"}); };
  const auto fine = quick(OwnLesson());
  EXPECT_EQ(fine.status, 0) << fine.out << fine.err;
  EXPECT_TRUE(fine.out.ends_with("3 claims, 0 questions, 0 bugs checked, 0 failed\n")) << fine.out;
  EXPECT_EQ(quick(OwnLesson("mutation shadows", "mutation shadow-epsilon")).status, 0) << "mutations are left out";
  const auto false_claim = quick(OwnLesson("bound >= 20000", "bound >= 300000"));
  EXPECT_EQ(false_claim.status, 1);
  EXPECT_NE(false_claim.out.find("DOES NOT HOLD"), std::string::npos) << false_claim.out;
  EXPECT_EQ(quick(OwnLesson("size 300x200", "scene ./none.scene")).status, 1);
}

TEST(LessonFolder, AFaultIsNamedWithItsPlace) {
  const OwnLesson lesson("bound >= 20000", "bound 20000");
  for (const std::string command : {"check", "show", "handout"}) {
    std::vector<std::string> arguments{"lessons", command, lesson.path()};
    if (command == "handout") arguments.insert(arguments.end(), {"--out", lesson.folder.file("x.html")});
    const auto refused = run_cli(arguments);
    EXPECT_EQ(refused.status, 2) << command;
    EXPECT_NE(refused.err.find("mine/lesson.md:34: found '20000', expected >=, <= or = and a number"),
              std::string::npos)
        << refused.err;
  }
}

TEST(LessonFolder, ATaskSaysThatAFoldersListingIsNotCompiled) {
  const OwnLesson lesson;
  const std::string file = lesson.path() + "/lesson.md", text = read_whole_file(file);
  std::ofstream(file, std::ios::binary) << text << "\n```task\nwrite draw_line\n```\n";
  std::ofstream(lesson.path() + "/listing.cpp") << "void draw_line() {}\n";
  const auto refused = run_cli({"lessons", "show", lesson.path()});
  EXPECT_EQ(refused.status, 2);
  EXPECT_EQ(refused.err.find("beside it"), std::string::npos) << "one lies there: " << refused.err;
  EXPECT_NE(refused.err.find("the program's own lessons"), std::string::npos) << refused.err;
}

TEST(LessonFolder, PlacesAreNamesFoldersAndSteps) {
  const OwnLesson lesson;
  const std::string path = lesson.path();
  EXPECT_EQ(parse_lesson_place(path), (LessonPlace{path, 0}));
  EXPECT_EQ(parse_lesson_place(path + "/"), (LessonPlace{path, 0}));
  EXPECT_EQ(parse_lesson_place(path + "/3"), (LessonPlace{path, 2}));
  EXPECT_EQ(parse_lesson_place(path + "/lesson.md"), (LessonPlace{path, 0}));
  EXPECT_EQ(load_lesson(path).name, path);
  EXPECT_TRUE(is_own_lesson(path));
  EXPECT_FALSE(is_own_lesson("cgfs_03_light"));
  EXPECT_EQ(lesson_folder_at("chapters/cgfs_03_light"),
            (std::filesystem::current_path() / "chapters/cgfs_03_light").string());
  EXPECT_EQ(lesson_folder_at(""), "");
  EXPECT_EQ(lesson_folder_at("assets"), "");
  EXPECT_EQ(lesson_folder_at(path + "/lesson.md/x"), "");
  for (const std::string& wrong : {path + "/0", path + "/x", path + "/3/4", std::string("/nowhere/at/all")})
    EXPECT_THROW(parse_lesson_place(wrong), InputError) << wrong;
  const Document linked = linked_document("lesson=" + percent_escape(path) + "&step=1");
  EXPECT_EQ(linked.lesson, path);
  EXPECT_EQ(linked.step, 1);
  EXPECT_EQ(linked.scene_name, path + "/balls.scene");
}

// --- handouts ---

std::size_t count_of(std::string_view text, std::string_view word) {
  std::size_t count = 0;
  for (auto at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

std::string from_base64(std::string_view text) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, held = 0;
  for (const char c : text.substr(0, text.find('='))) {
    bits = bits << 6 | static_cast<unsigned>(digits.find(c));
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> held & 0xff);
  }
  return bytes;
}

std::string handout(const OwnLesson& lesson, const std::string& how = {}) {
  std::vector<std::string> arguments{"lessons", "handout", lesson.path(), "--out", lesson.folder.file("page.html")};
  if (!how.empty()) arguments.push_back(how);
  run_cli_well(arguments);
  return read_whole_file(lesson.folder.file("page.html"));
}

TEST(LessonHandout, NeedsNothingElse) {
  const OwnLesson lesson;
  const std::string page = handout(lesson);
  EXPECT_EQ(test::markup_fault(page), "");
  EXPECT_EQ(count_of(page, "http"), 1u);  // the name of the markup itself
  EXPECT_NE(page.find("xmlns=\"http://www.w3.org/1999/xhtml\""), std::string::npos);
  EXPECT_EQ(count_of(page, "src=\"data:image/png;base64,"), count_of(page, "src="));
  EXPECT_NE(page.find("How many shadow rays does B cast?"), std::string::npos);
  EXPECT_NE(page.find("pixelscope --lesson " + lesson.path()), std::string::npos);
  EXPECT_NE(page.find("<b>B</b> without shadows"), std::string::npos);
  EXPECT_NE(page.find("count the rays of shadows"), std::string::npos);
}

TEST(LessonHandout, OnlyTheTeachersHasTheAnswers) {
  const OwnLesson lesson;
  const std::string student = handout(lesson), teacher = handout(lesson, "--teacher");
  EXPECT_EQ(test::markup_fault(teacher), "");
  for (const char* words : {"<b>Answer 1.</b>", "<b>Next:</b> the end of the lesson", "Claim",
                            "The shadows cover more than 20,000 pixels.", "pixels that differ: "}) {
    EXPECT_EQ(student.find(words), std::string::npos) << words;
    EXPECT_NE(teacher.find(words), std::string::npos) << words;
  }
  EXPECT_NE(student.find("Name"), std::string::npos);
  EXPECT_NE(student.find("class=\"tick\""), std::string::npos);
  EXPECT_EQ(student.find("never asks whether a light is blocked"), std::string::npos);
  EXPECT_NE(teacher.find("never asks whether a light is blocked"), std::string::npos);
  EXPECT_NE(teacher.find("60,000 rays"), std::string::npos);
  EXPECT_EQ(count_of(student, "<img "), 9u);  // B of the second step answers its question
  EXPECT_EQ(count_of(student, "is shown in the program after your answer"), 1u);
  EXPECT_EQ(count_of(teacher, "<img "), 10u);
}

TEST(LessonHandout, OnlyTheTeachersHasTheNotes) {
  const OwnLesson lesson("## The first step\n",
                         "```notes\nBegin with a lamp.\n```\n\n## The first step\n\n```notes\nAsk for $N$.\n```\n");
  const std::string student = handout(lesson), teacher = handout(lesson, "--teacher");
  EXPECT_EQ(test::markup_fault(teacher), "");
  for (const char* words : {"Begin with a lamp.", "Ask for ", "For the teacher"}) {
    EXPECT_EQ(student.find(words), std::string::npos) << words;
    EXPECT_NE(teacher.find(words), std::string::npos) << words;
  }
  EXPECT_LT(teacher.find("Begin with a lamp."), teacher.find("id=\"step-1\""));
  EXPECT_GT(teacher.find("Ask for "), teacher.find("id=\"step-1\""));
}

TEST(LessonHandout, ItsPicturesAreThoseOfTheRenderCommand) {
  const OwnLesson lesson;
  const std::string page = handout(lesson);
  constexpr std::string_view before = "base64,";
  const auto at = page.find(before) + before.size();
  const auto made = lesson.folder.write("embedded.png", from_base64(page.substr(at, page.find('"', at) - at)));
  const std::string permalink = ps::permalink(lesson_document(load_lesson(lesson.path()), 0, Document{}));
  const auto rendered = run_cli_well({"render", "--permalink", permalink, "--out", lesson.folder.file("rendered.png")});
  EXPECT_EQ(load_levels(made), load_levels(lesson.folder.file("rendered.png")));
}

TEST(LessonHandout, TextsAreEscaped) {
  const Lesson lesson = parse_lesson(
      "# A < B & C\nsource: \"x\"\n\n1 < 2 & `a<b>`\n\n- one\n- *two*\n\n3. three\n\n## S\n\n```settings\nscene "
      "cgfs/spheres\n```\n",
      "demo", "lesson.md");
  const std::string html = block_html(lesson.blocks);
  EXPECT_EQ(html, "<p>1 &lt; 2 &amp; <code>a&lt;b&gt;</code></p>\n<ul>\n<li>one</li>\n<li><em>two</em></li>\n</ul>\n"
                  "<ol start=\"3\">\n<li>three</li>\n</ol>\n");
  const std::string index = handout_index({}, {lesson});
  EXPECT_EQ(test::markup_fault(index), "");
  EXPECT_NE(index.find("<a href=\"demo.html\">A &lt; B &amp; C</a>"), std::string::npos);
}

TEST(LessonHandout, ThePageOfTheCourseFillsClasses) {
  const auto lesson = [](const std::string& name, int steps) {
    std::string text = "# Title of " + name + "\nsource: s\n\n```goals\nsay " + name + "\n```\n";
    for (int i = 0; i < steps; ++i) text += "\n## S\n\nWord.\n\n```settings\nscene cgfs/spheres\n```\n";
    return parse_lesson(text, name, "lesson.md");
  };
  // Half a minute for each step, rounded up with the words: 21, 16, 31 and 11 minutes.
  const std::vector<Lesson> lessons{lesson("one", 40), lesson("two", 30), lesson("three", 60), lesson("four", 20)};
  const Course course{"Course", {{"First", {{"one", {}}, {"two", {"one"}}}}, {"Second", {{"three", {"two"}}}}}, {}};
  const std::string page = handout_index(course, lessons);
  EXPECT_EQ(test::markup_fault(page), "");
  const auto at = [&](const std::string& words) {
    EXPECT_NE(page.find(words), std::string::npos) << words;
    return page.find(words);
  };
  EXPECT_LT(at("<h2>First</h2>"), at("<h2>Second</h2>"));
  EXPECT_LT(at("<h2>Second</h2>"), at("<h2>Further lessons</h2>"));
  at("<li>say three</li>");
  const std::string one = "<a href=\"one.html\">Title of one</a>", two = "<a href=\"two.html\">Title of two</a>",
                    three = "<a href=\"three.html\">Title of three</a>";
  at("<td>1</td><td>" + one + ", " + two + "</td><td>37</td>");
  at("<td>2</td><td>" + three + "</td><td>31</td>");
  at("<td>1</td><td>" + one + ", " + two + ", " + three + "</td><td>68</td>");
}

TEST(LessonHandout, WhatCannotBeMadeIsRefused) {
  const ScratchFolder folder;
  EXPECT_EQ(run_cli({"lessons", "handout", "--out", folder.file("x.html")}).status, 2);
  EXPECT_EQ(run_cli({"lessons", "handout", "cgfs_03_light", "--all", "--out", folder.file("x")}).status, 2);
  EXPECT_EQ(run_cli({"lessons", "handout", "cgfs_03_ligt", "--out", folder.file("x.html")}).status, 2);
  EXPECT_EQ(run_cli({"lessons", "handout", "cgfs_03_light", "--out", folder.file("no/x.html")}).status, 2);
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace ps::lesson_folder_test
