// Typesetting of formulas as geometry, with a font whose letters are boxes: what lies above, below, beside what.
#include "engine/maths_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "engine/markdown.h"
#include "engine/maths_specimen.h"

namespace maths_layout_test {
namespace {

using namespace ps;
using ps::Formula;
using ps::FormulaForm;
using ps::MathsStyle;

/// Each character is half an em wide and 0.7 em high; "y" hangs below the baseline, a minus lies around the axis.
class BoxFont : public MathsFont {
 public:
  explicit BoxFont(float em) : em_(em) {}
  InkBox ink(MathsStyle, MathsSize size, std::string_view utf8) const override {
    const float e = em(size);
    float count = 0;
    for (const char c : utf8) count += (static_cast<unsigned char>(c) & 0xC0u) != 0x80u ? 1.f : 0.f;
    const float width = count * e / 2;
    if (utf8 == "−") return {width, 0, width, 0.3f * e, -0.2f * e};
    return {width, 0, width, 0.7f * e, utf8 == "y" ? 0.2f * e : 0.f};
  }
  float em(MathsSize size) const override { return size == MathsSize::text ? em_ : 0.7f * em_; }

 private:
  float em_;
};

Formula read(const std::string& notation, FormulaForm form = FormulaForm::in_text) {
  return ps::read_formula(notation, form, {"test", 1, 1});
}

MathsBox set(const std::string& notation, float em = 20) {
  const auto boxes = set_in_text(read(notation), BoxFont(em), 1e6f);
  EXPECT_EQ(boxes.size(), 1u);
  return boxes.front();
}

MathsBox display(const std::string& notation, float em = 20) {
  const auto boxes = set_displayed(read(notation, FormulaForm::display), BoxFont(em), 1e6f);
  EXPECT_EQ(boxes.size(), 1u);
  return boxes.front();
}

const MathsText& text_of(const MathsBox& box, std::string_view text) {
  const auto found =
      std::find_if(box.texts.begin(), box.texts.end(), [&](const auto& each) { return each.text == text; });
  EXPECT_NE(found, box.texts.end()) << text;
  static const MathsText none;
  return found == box.texts.end() ? none : *found;
}

TEST(MathsLayout, LettersStandSideBySide) {
  const MathsBox box = set("ab");
  EXPECT_FLOAT_EQ(text_of(box, "a").x, 0);
  EXPECT_FLOAT_EQ(text_of(box, "b").x, 10);
  EXPECT_FLOAT_EQ(box.width, 20);
  EXPECT_FLOAT_EQ(box.above, 14);
  EXPECT_FLOAT_EQ(box.below, 0);
}

TEST(MathsLayout, BinarySignsHaveSpaceAndSignsOfNumbersHaveNone) {
  EXPECT_FLOAT_EQ(set("a-b").width, 30 + 2 * 20 * 4.0f / 18);
  EXPECT_FLOAT_EQ(set("-b").width, 20);
}

TEST(MathsLayout, ScriptsAreSmallerAndOnBothSidesOfTheBaseline) {
  const MathsBox box = set("a_i^2");
  const MathsText &sub = text_of(box, "i"), &super = text_of(box, "2");
  EXPECT_EQ(sub.size, MathsSize::script);
  EXPECT_GT(sub.y, 0);
  EXPECT_LT(super.y, 0);
  EXPECT_GT(super.x, sub.x);  // the letter is slanted
  EXPECT_GE(sub.y - 0.7f * 14, super.y) << "they lie over each other";
  // Baselines are whole pixels, or letters are blurred.
  EXPECT_FLOAT_EQ(sub.y, std::round(sub.y));
  EXPECT_FLOAT_EQ(super.y, std::round(super.y));
}

TEST(MathsLayout, FractionsAreCentredOnTheAxis) {
  for (const float em : {17.f, 20.f, 25.5f, 51.f}) {
    const MathsBox box = display("\\frac{ab}{y}", em);
    ASSERT_EQ(box.rules.size(), 1u);
    const MathsRule& bar = box.rules.front();
    EXPECT_NEAR(bar.y + bar.height / 2, -0.25f * em, 1) << em;
    EXPECT_FLOAT_EQ(bar.y, std::round(bar.y));
    const MathsText &above = text_of(box, "a"), &below = text_of(box, "y");
    EXPECT_LT(above.y, bar.y - 1);
    EXPECT_GT(below.y - 0.7f * em, bar.y + bar.height + 1);
    EXPECT_NEAR(below.x + em / 4, bar.x + bar.width / 2, 0.01) << "not centred";
    EXPECT_GE(bar.width, em);
    EXPECT_GE(box.below, below.y + 0.2f * em - 0.01f);
  }
  EXPECT_EQ(text_of(set("\\frac{a}{b}"), "a").size, MathsSize::script) << "in a text";
  EXPECT_EQ(text_of(display("\\frac{a}{b}"), "a").size, MathsSize::text);
}

TEST(MathsLayout, RootsCoverWhatIsInside) {
  const MathsBox box = set("\\sqrt{ab}"), high = display("\\sqrt[3]{\\frac{a}{b}}");
  ASSERT_EQ(box.rules.size(), 1u);
  EXPECT_LE(box.rules[0].x, text_of(box, "a").x);
  EXPECT_GE(box.rules[0].x + box.rules[0].width, text_of(box, "b").x + 10);
  EXPECT_LT(box.rules[0].y, -14);
  ASSERT_EQ(box.strokes.size(), 1u);
  EXPECT_GT(high.height(), box.height() + 10);
  EXPECT_LT(text_of(high, "3").x, text_of(high, "a").x);
}

TEST(MathsLayout, FencesGrowWithTheirInside) {
  EXPECT_TRUE(set("\\left( a \\right)").strokes.empty()) << "the font's own do";
  const MathsBox box = display("\\left( \\frac{a}{b} \\right)");
  ASSERT_EQ(box.strokes.size(), 2u);
  const auto [low, high] = std::minmax_element(box.strokes[0].points.begin(), box.strokes[0].points.end(),
                                               [](const auto& a, const auto& b) { return a.y < b.y; });
  EXPECT_LE(low->y, text_of(box, "a").y - 13);
  EXPECT_GE(high->y, text_of(box, "b").y);
  EXPECT_EQ(display("\\left\\| \\frac{a}{b} \\right\\|").strokes.size(), 4u);
  EXPECT_EQ(display("\\left. \\frac{a}{b} \\right|").strokes.size(), 1u);
}

TEST(MathsLayout, MatricesHaveColumnsAndRows) {
  const MathsBox box = display("\\begin{pmatrix}a & b\\\\ccc & d\\end{pmatrix}");
  EXPECT_FLOAT_EQ(text_of(box, "b").x, text_of(box, "d").x);
  EXPECT_FLOAT_EQ(text_of(box, "a").y, text_of(box, "b").y);
  EXPECT_GE(text_of(box, "d").y - text_of(box, "b").y, 20);
  EXPECT_GT(text_of(box, "a").x, text_of(box, "c").x) << "cells are centred";
  const MathsBox cases = display("\\begin{cases}a & b\\\\ccc & d\\end{cases}");
  EXPECT_FLOAT_EQ(text_of(cases, "a").x, text_of(cases, "c").x) << "cells begin at the left";
  EXPECT_NEAR((box.above - box.below) / 2, 5, 1.5) << "around the axis";
}

TEST(MathsLayout, LimitsStandAboveAndBelowInDisplays) {
  const MathsBox box = display("\\sum_{i}^{n} a");
  EXPECT_GT(text_of(box, "i").y, 15);
  EXPECT_LT(text_of(box, "n").y, -20);
  EXPECT_FLOAT_EQ(text_of(box, "i").x, text_of(box, "n").x);
  EXPECT_GT(text_of(box, "a").x, text_of(box, "n").x);
  const MathsBox text = set("\\sum_{i}^{n} a");
  EXPECT_GE(text_of(text, "i").x, 10);
  EXPECT_LT(text_of(text, "i").y, 15);
  const MathsBox limit = display("\\lim_{z} a");
  EXPECT_GT(text_of(limit, "z").y, 10);
}

TEST(MathsLayout, AccentsStandAboveTheirLetter) {
  const MathsBox vector = set("\\vec{ab}"), bar = set("\\bar a"), hat = set("\\hat a");
  for (const MathsStroke& stroke : vector.strokes)
    for (const MathsPoint& point : stroke.points) EXPECT_LT(point.y, -14);
  EXPECT_EQ(vector.strokes.size(), 2u);
  EXPECT_EQ(bar.rules.size(), 1u);
  EXPECT_LT(bar.rules[0].y, -14);
  EXPECT_EQ(hat.strokes.size(), 1u);
  EXPECT_GT(vector.above, 15);
}

TEST(MathsLayout, LinesEndBehindRelations) {
  const BoxFont font(20);
  const Formula formula = read("a = b + c = d", FormulaForm::display);
  EXPECT_EQ(set_in_text(formula, font, 1000).size(), 3u);
  EXPECT_EQ(set_in_text(formula, font, 35).size(), 4u) << "b + c = is too wide";
  EXPECT_EQ(set_displayed(formula, font, 1000).size(), 1u);
  const auto lines = set_displayed(formula, font, 90);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].texts.back().text, "=");
  for (const MathsBox& line : lines) EXPECT_LE(line.width, 90);
  EXPECT_EQ(set_displayed(formula, font, 1).size(), 4u) << "no place is left to part it";
  const auto apart = set_displayed(read("a + b \\quad c + d", FormulaForm::display), font, 60);
  ASSERT_EQ(apart.size(), 2u);
  EXPECT_EQ(apart[0].texts.back().text, "b") << "a wide space is the best place";
}

/// Everything grows with the type, and nothing lies outside its box.
TEST(MathsLayout, TheSpecimenFitsItsBoxesAtEverySize) {
  int formulas = 0;
  for (const ps::TextBlock& block : ps::read_markdown(ps::maths_specimen(), "specimen", 1).blocks)
    for (const ps::TextSpan& span : block.spans) {
      if (!span.formula) continue;
      ++formulas;
      for (const float em : {12.75f, 17.f, 25.5f, 68.f}) {
        const BoxFont font(em);
        const float slack = 0.15f * em + 1;
        for (const MathsBox& box : set_displayed(*span.formula, font, 1e6f)) {
          for (const MathsText& text : box.texts) {
            const InkBox ink = font.ink(text.style, text.size, text.text);
            EXPECT_GE(text.x, -0.01f) << span.text;
            EXPECT_LE(text.x + ink.advance, box.width + slack) << span.text;
            EXPECT_LE(ink.above - text.y, box.above + 1) << span.text;
            EXPECT_LE(ink.below + text.y, box.below + 1) << span.text;
          }
          for (const MathsStroke& stroke : box.strokes)
            for (const MathsPoint& point : stroke.points) {
              EXPECT_GE(point.x, -slack) << span.text;
              EXPECT_LE(point.x, box.width + slack) << span.text;
              EXPECT_LE(-point.y, box.above + slack) << span.text;
              EXPECT_LE(point.y, box.below + slack) << span.text;
            }
          for (const MathsRule& rule : box.rules) {
            EXPECT_GE(rule.height, 1);
            EXPECT_LE(rule.x + rule.width, box.width + slack) << span.text;
          }
        }
      }
      const float small = set_displayed(*span.formula, BoxFont(17), 1e6f)[0].width,
                  large = set_displayed(*span.formula, BoxFont(34), 1e6f)[0].width;
      EXPECT_NEAR(large, 2 * small, 0.1 * large + 2) << span.text;
    }
  EXPECT_GT(formulas, 25);
}

}  // namespace
}  // namespace maths_layout_test
