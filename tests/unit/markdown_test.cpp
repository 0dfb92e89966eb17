// The text of lessons: what is read, and that every fault is named with its line and column.
#include "engine/markdown.h"

#include <gtest/gtest.h>

#include "support/refusal.h"

namespace ps::markdown_test {
namespace {

StepText read(const std::string& text) { return read_markdown(text, "lesson.md", 10); }

std::string error_of(const std::string& text) {
  return test::refusal_of([&] { read(text); });
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
  EXPECT_EQ(link_of("Microscope"), (TextLink{LinkKind::panel, "microscope", 0, {}}));
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
  EXPECT_EQ(error_of("cost $2"), "lesson.md:10:6: found '$' without its partner, expected '\\$' for the sign itself");
  EXPECT_EQ(error_of("a &nbsp; b").substr(0, 25), "lesson.md:10:3: found '&n");
}

TEST(Markdown, ReadsFormulas) {
  const StepText text =
      read("Half $\\frac{1}{2}$, *all $x_i$* `$5` \\$ [to $N$](panel:parting).\n\n$${a_b}_c\n= [c]$$\n"
           "\n> $x$ here.\n\n- $a_1$$b$\n");
  ASSERT_EQ(text.blocks.size(), 3u);
  EXPECT_EQ(plain_text(text.blocks[0]), "Half 1 / 2, all x_i $5 $ to N.");
  const auto& spans = text.blocks[0].spans;
  ASSERT_TRUE(spans[1].formula.has_value());
  EXPECT_EQ(spans[1].formula->notation, "\\frac{1}{2}");
  EXPECT_EQ(spans[3].formula, std::nullopt);
  ASSERT_TRUE(spans[4].formula.has_value());
  EXPECT_EQ(spans[4].style, TextStyle::emphasis);
  EXPECT_EQ(spans[4].formula->notation, "x_i");
  ASSERT_TRUE(spans[9].formula.has_value());
  EXPECT_EQ(spans[9].formula->notation, "N");
  EXPECT_EQ(spans[9].link.target, "parting");
  EXPECT_EQ(display_formula(text.blocks[0]), nullptr);
  ASSERT_NE(display_formula(text.blocks[1]), nullptr);
  EXPECT_EQ(display_formula(text.blocks[1])->notation, "{a_b}_c\n= [c]");
  EXPECT_EQ(plain_text(text.hints.at(0)), "x here.");
  EXPECT_EQ(plain_text(text.blocks[2]), "a₁b");
}

TEST(Markdown, NamesFaultsInFormulas) {
  EXPECT_EQ(error_of("one\n- two $x + \\aplha$"),
            "lesson.md:11:12: found the unknown command '\\aplha', expected '\\alpha'");
  EXPECT_EQ(error_of("one\n\n$$x\n+ \\aplha$$"),
            "lesson.md:13:3: found the unknown command '\\aplha', expected '\\alpha'");
  EXPECT_EQ(error_of("a $x\n\ny$"),
            "lesson.md:10:3: found '$' without its partner, expected '\\$' for the sign itself");
  EXPECT_EQ(error_of("a $$x$$ b"),
            "lesson.md:10:3: found '$$' inside a text, expected a paragraph of its own, or single '$'");
  EXPECT_EQ(error_of("> $$x$$").substr(0, 21), "lesson.md:10:3: found");
  EXPECT_EQ(error_of("> $x\n> + y$"),
            "lesson.md:10:3: found a formula over several lines in a hint, expected one line");
  EXPECT_EQ(error_of("$$"), "lesson.md:10:1: found '$$' without its partner, expected '\\$' for the sign itself");
  EXPECT_EQ(error_of("$ $").substr(0, 36), "lesson.md:10:2: found an empty formu");
  EXPECT_EQ(error_of("a \x01"), "lesson.md:10:3: found a control character, expected text");
}

TEST(Markdown, TermsInEmphasisLeadToTheGlossary) {
  const auto spans =
      read("A *vertex*, *Vertices*, *many* and [corners](term:vertex), [sum](term:dot-product).").blocks[0].spans;
  const TextLink vertex{LinkKind::term, "vertex", 0, {}};
  EXPECT_EQ(spans[1].link, vertex);
  EXPECT_EQ(spans[3].link, vertex);
  EXPECT_EQ(spans[5].link, TextLink{});
  EXPECT_EQ(spans[7], (TextSpan{"corners", TextStyle::plain, vertex}));
  EXPECT_EQ(spans[9].link.target, "dot product");
  EXPECT_EQ(error_of("two [corners](term:vertx)"), "lesson.md:10:5: unknown term 'vertx'; did you mean 'vertex'?");
}

}  // namespace
}  // namespace ps::markdown_test
