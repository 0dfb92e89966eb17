// The text of lessons: what is read, and that every fault is named with its line and column.
#include "engine/markdown.h"

#include <gtest/gtest.h>

namespace ps {
namespace markdown_test {
namespace {

StepText read(const std::string& text) { return read_markdown(text, "lesson.md", 10); }

std::string error_of(const std::string& text) {
  try {
    read(text);
    return "no error";
  } catch (const InputError& error) {
    return error.what();
  }
}

TextSpan plain(const std::string& text) { return {text, TextStyle::plain, {}}; }

TEST(Markdown, ReadsStylesInParagraphs) {
  const StepText text = read("First *line* and\nsecond **one** of `code`.\n\nAnother, with 2 \\* 3 \\[x\\].");
  ASSERT_EQ(text.blocks.size(), 2u);
  EXPECT_EQ(text.blocks[0].spans, (std::vector<TextSpan>{plain("First "),
                                                         {"line", TextStyle::emphasis, {}},
                                                         plain(" and second "),
                                                         {"one", TextStyle::strong, {}},
                                                         plain(" of "),
                                                         {"code", TextStyle::code, {}},
                                                         plain(".")}));
  EXPECT_EQ(plain_text(text.blocks[1]), "Another, with 2 * 3 [x].");
}

TEST(Markdown, ReadsHeadingsListsAndHints) {
  const StepText text =
      read("### Part\n\n- one\n- two\n  goes on\n\n3. three\n4. four\n\n> Look *here*\n> and here.\n\n> There.\n");
  ASSERT_EQ(text.blocks.size(), 5u);
  EXPECT_EQ(text.blocks[0].kind, BlockKind::heading);
  EXPECT_EQ(text.blocks[1].kind, BlockKind::bullet);
  EXPECT_EQ(plain_text(text.blocks[2]), "two goes on");
  EXPECT_EQ(text.blocks[3].kind, BlockKind::numbered);
  EXPECT_EQ(text.blocks[3].number, 3);
  EXPECT_EQ(text.blocks[4].number, 4);
  ASSERT_EQ(text.hints.size(), 2u);
  EXPECT_EQ(plain_text(text.hints[0]), "Look here and here.");
  EXPECT_EQ(plain_text(text.hints[1]), "There.");
}

TEST(Markdown, ReadsLinksAndControls) {
  const StepText text =
      read("See [why *they* part](panel:parting), [step](step:2), [light](lesson:cgfs_03_light/3).\n\n"
           "Raise [[a.shadow-epsilon]] and [[shading]].");
  const auto& spans = text.blocks[0].spans;
  const TextLink parting{LinkKind::panel, "parting", 0, {}};
  EXPECT_EQ(spans[1], (TextSpan{"why ", TextStyle::plain, parting}));
  EXPECT_EQ(spans[2], (TextSpan{"they", TextStyle::emphasis, parting}));
  EXPECT_EQ(spans[5].link, (TextLink{LinkKind::step, "", 1, {}}));
  EXPECT_EQ(spans[7].link, (TextLink{LinkKind::lesson, "cgfs_03_light", 2, {}}));
  EXPECT_EQ(text.step_links.at(0).step, 1);
  EXPECT_EQ(text.step_links.at(0).place.line, 10);
  EXPECT_EQ(text.blocks[1].spans[1],
            (TextSpan{"Shadow epsilon", TextStyle::plain, {LinkKind::control, "shadow-epsilon", 0, Side::a}}));
  EXPECT_EQ(text.blocks[1].spans[3].link, (TextLink{LinkKind::control, "shading", 0, {}}));
}

TEST(Markdown, NamesInBoldLeadToTheirOptionOrPanel) {
  const auto link_of = [](const std::string& name) { return read("**" + name + "**").blocks.at(0).spans.at(0).link; };
  EXPECT_EQ(link_of("Shadow epsilon"), (TextLink{LinkKind::option, "shadow-epsilon", 0, {}}));
  EXPECT_EQ(link_of("shadow-epsilon"), (TextLink{LinkKind::option, "shadow-epsilon", 0, {}}));
  EXPECT_EQ(link_of("MICROSCOPE"), (TextLink{LinkKind::panel, "microscope", 0, {}}));
  EXPECT_EQ(link_of("Parting"), (TextLink{LinkKind::panel, "parting", 0, {}}));
  EXPECT_EQ(link_of("very").kind, LinkKind::none);
}

TEST(Markdown, EveryFaultIsNamedWithItsPlace) {
  EXPECT_EQ(error_of("Good.\n\nA **bold word."),
            "lesson.md:12:3: found '*' without its partner, expected '\\*' for the sign itself");
  EXPECT_EQ(error_of("A `word."), "lesson.md:10:3: found '`' without its partner, expected '\\`' for the sign itself");
  EXPECT_EQ(error_of("A [word](panel:parting."),
            "lesson.md:10:3: found '[' without its partner, expected '\\[' for the sign itself");
  EXPECT_EQ(error_of("text\nA [word](panel:partin)"),
            "lesson.md:11:3: unknown panel 'partin'; did you mean 'parting'?");
  EXPECT_EQ(error_of("An [[shadow-epsilom]]"),
            "lesson.md:10:4: unknown option 'shadow-epsilom'; did you mean 'shadow-epsilon'?");
  EXPECT_EQ(error_of("A [word](step:0)"), "lesson.md:10:3: found the step '0', expected a whole number from 1");
  EXPECT_EQ(error_of("A [word](https://example.org)").substr(0, 36), "lesson.md:10:3: found the link 'http");
  EXPECT_EQ(error_of("A [word](lesson:cgfs_03_ligth)"),
            "lesson.md:10:3: unknown lesson 'cgfs_03_ligth'; did you mean 'cgfs_03_light'?");
  EXPECT_EQ(error_of("text\n\n![alt](picture.png)").substr(0, 29), "lesson.md:12:1: found a pictu");
  EXPECT_EQ(error_of("text\n\n---\n").substr(0, 31), "lesson.md:12:1: found a line ac");
  EXPECT_EQ(error_of("text\n---\n").substr(0, 34), "lesson.md:10:1: found a heading of");
  EXPECT_EQ(error_of("~~~\ncode\n~~~").substr(0, 32), "lesson.md:10:1: found a block of");
  EXPECT_EQ(error_of("one\\\ntwo").substr(0, 34), "lesson.md:10:4: found a line break");
  EXPECT_EQ(error_of("- one\n  - two").substr(0, 36), "lesson.md:11:3: found a list inside ");
  EXPECT_EQ(error_of("> - one").substr(0, 33), "lesson.md:10:1: found a list in a");
  EXPECT_EQ(error_of("- one\n\n  two\n").substr(0, 36), "lesson.md:12:3: found a second parag");
  EXPECT_EQ(error_of("cost $x^2$").substr(0, 33), "lesson.md:10:6: found a formula b");
  EXPECT_EQ(error_of("a &nbsp; b").substr(0, 25), "lesson.md:10:3: found '&n");
}

}  // namespace
}  // namespace markdown_test
}  // namespace ps
