// The notation of formulas: what is read, what is written as MathML and as plain text, and where each fault is named.
#include "engine/maths.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>

#include "engine/markdown.h"
#include "engine/maths_signs.h"
#include "engine/maths_specimen.h"
#include "engine/maths_writers.h"
#include "support/golden.h"
#include "support/refusal.h"
#include "support/well_formed.h"

namespace ps::maths_test {
namespace {

Formula read(std::string_view notation, FormulaForm form = FormulaForm::in_text) {
  return read_formula(notation, form, {"lesson.md", 7, 11});
}

std::string error_of(std::string_view notation) {
  return test::refusal_of([&] { read(notation); });
}

std::string plain(std::string_view notation) { return plain_maths(read(notation)); }

/// The inside of the <math> element.
std::string markup(std::string_view notation, FormulaForm form = FormulaForm::in_text) {
  const std::string all = mathml(read(notation, form));
  const auto begin = all.find("<mrow>") + 6;
  return all.substr(begin, all.size() - begin - std::string_view("</mrow></math>").size());
}

TEST(Maths, WritesPlainText) {
  EXPECT_EQ(plain("a t^2 + b t + c = 0"), "at² + bt + c = 0");
  EXPECT_EQ(plain("a\\,t^2"), "a t²");
  EXPECT_EQ(plain("t = \\frac{-b \\pm \\sqrt{b^2 - 4ac}}{2a}"), "t = (−b ± √(b² − 4ac)) / (2a)");
  EXPECT_EQ(plain("\\frac{1}{2}"), "1 / 2");
  EXPECT_EQ(plain("\\sqrt{2} + \\sqrt[3]{x}"), "√2 + ³√x");
  EXPECT_EQ(plain("x_1 + x_{i+1} + x_i + 2^{-n} + e^{x/y} + f'"), "x₁ + x_(i + 1) + x_i + 2⁻ⁿ + e^(x/y) + f′");
  EXPECT_EQ(plain("\\lVert\\vec N\\rVert\\cos\\theta"), "‖N‖ cos θ");
  EXPECT_EQ(plain("\\sum_{i=1}^{n} w_i"), "∑_(i = 1)ⁿ w_i");
  EXPECT_EQ(plain("\\begin{pmatrix}1 & 2\\\\ 3 & 4\\end{pmatrix}"), "(1, 2; 3, 4)");
  EXPECT_EQ(plain("\\begin{cases}1 & \\text{if } x > 0\\\\0 & \\text{else}\\end{cases}"), "{1, if x > 0; 0, else");
  EXPECT_EQ(plain("-x, (-y)"), "−x, (−y)");
}

TEST(Maths, WritesMathMl) {
  EXPECT_EQ(mathml(read("x")),
            "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" display=\"inline\"><mrow><mi>x</mi></mrow></math>");
  EXPECT_NE(mathml(read("x", FormulaForm::display)).find("display=\"block\""), std::string::npos);
  EXPECT_EQ(markup("x_1^2"), "<msubsup><mi>x</mi><mn>1</mn><mn>2</mn></msubsup>");
  EXPECT_EQ(markup("x^{n+1}"), "<msup><mi>x</mi><mrow><mi>n</mi><mo>+</mo><mn>1</mn></mrow></msup>");
  EXPECT_EQ(markup("\\frac{a}{bc}"), "<mfrac><mi>a</mi><mrow><mi>b</mi><mi>c</mi></mrow></mfrac>");
  EXPECT_EQ(markup("\\sqrt{2}"), "<msqrt><mn>2</mn></msqrt>");
  EXPECT_EQ(markup("\\sqrt[3]{x}"), "<mroot><mi>x</mi><mn>3</mn></mroot>");
  EXPECT_EQ(markup("\\vec N"), "<mover accent=\"true\"><mi>N</mi><mo>→</mo></mover>");
  EXPECT_EQ(markup("\\sum_i^n", FormulaForm::display), "<munderover><mo>∑</mo><mi>i</mi><mi>n</mi></munderover>");
  EXPECT_EQ(markup("\\sum_i^n"), "<msubsup><mo>∑</mo><mi>i</mi><mi>n</mi></msubsup>");
  EXPECT_EQ(markup("\\int_i^n", FormulaForm::display), "<msubsup><mo>∫</mo><mi>i</mi><mi>n</mi></msubsup>");
  EXPECT_EQ(markup("a < b"), "<mi>a</mi><mo>&lt;</mo><mi>b</mi>");
  EXPECT_EQ(markup("\\mathbf{R2}"), "<mrow><mi>𝐑</mi><mn>𝟐</mn></mrow>");
  EXPECT_EQ(
      markup("\\begin{pmatrix}1\\\\2\\end{pmatrix}"),
      "<mrow><mo form=\"prefix\" stretchy=\"true\">(</mo><mtable><mtr><mtd><mn>1</mn></mtd></mtr><mtr><mtd><mn>2</mn>"
      "</mtd></mtr></mtable><mo form=\"postfix\" stretchy=\"true\">)</mo></mrow>");
}

TEST(Maths, NamesEachFaultWithItsPlace) {
  EXPECT_EQ(error_of("x + \\frc{1}{2}"), "lesson.md:7:15: found the unknown command '\\frc', expected '\\frac'");
  EXPECT_EQ(
      error_of("x\n  + \\Qqqqqq"),
      "lesson.md:8:5: found the unknown command '\\Qqqqqq', expected a command of the notation (chapters/README.md "
      "lists them)");
  EXPECT_EQ(error_of("N·L"), "lesson.md:7:12: found '·', expected '\\cdot'");
  EXPECT_EQ(error_of("2 * 3"), "lesson.md:7:13: found '*', expected '\\cdot'");
  EXPECT_EQ(error_of("{x"), "lesson.md:7:11: found '{' without its '}', expected '\\{' for the sign itself");
  EXPECT_EQ(error_of("x}"), "lesson.md:7:12: found '}' without its '{', expected '\\}' for the sign itself");
  EXPECT_EQ(error_of("x^2^3"), "lesson.md:7:14: found a second superscript, expected {...} around the first one");
  EXPECT_EQ(error_of("x_2_3"), "lesson.md:7:14: found a second subscript, expected {...} around the first one");
  EXPECT_EQ(error_of("^2"), "lesson.md:7:11: found '^' without a base, expected a sign or {...} before it");
  EXPECT_EQ(error_of("x^"), "lesson.md:7:13: found nothing, expected {...} or a sign behind '^'");
  EXPECT_EQ(error_of("\\frac{1}"), "lesson.md:7:19: found nothing, expected {...} or a sign behind 'frac'");
  EXPECT_EQ(error_of("a & b"), "lesson.md:7:13: found '&' outside a matrix, expected \\begin{matrix} before it");
  EXPECT_EQ(
      error_of("\\left( x"),
      "lesson.md:7:11: found '\\left' without its '\\right', expected '\\right' and a delimiter, or '\\right.' for "
      "none");
  EXPECT_EQ(error_of("\\left x \\right)").substr(0, 35), "lesson.md:7:17: found no delimiter,");
  EXPECT_EQ(error_of("\\begin{pmatrx}1\\end{pmatrx}"),
            "lesson.md:7:17: found the environment 'pmatrx', expected 'pmatrix'");
  EXPECT_EQ(error_of("\\begin{matrix}1 & 2\\\\3\\end{matrix}"),
            "lesson.md:7:11: found rows of 2 and 1 cells, expected equally many in each row");
  EXPECT_EQ(error_of("\\begin{matrix}1"), "lesson.md:7:11: found '\\begin{matrix}' without its end, expected "
                                          "'\\end{matrix}'");
  EXPECT_EQ(error_of("\\begin{matrix}1\\end{cases}"),
            "lesson.md:7:26: found the end of another environment, expected '\\end{matrix}'");
  EXPECT_EQ(error_of("\\sqrt[3 x"),
            "lesson.md:7:16: found '[' without its ']', expected the degree of the root between "
            "them");
  EXPECT_EQ(error_of("  "), "lesson.md:7:11: found an empty formula, expected something between the dollar signs");
  EXPECT_EQ(error_of("\\"), "lesson.md:7:11: found '\\' at the end, expected a command behind it");
  EXPECT_EQ(error_of(std::string(17, '{') + "x" + std::string(17, '}')),
            "lesson.md:7:27: found a formula nested too deeply, expected at most 16 levels");
  EXPECT_EQ(error_of(std::string(2001, 'x')), "lesson.md:7:11: found a formula of 2001 bytes, expected at most 2000");
  std::string accents;
  for (int i = 0; i < 300; ++i) accents += "\\vec ";
  EXPECT_NE(error_of(accents + "x").find("nested too deeply"), std::string::npos);
}

TEST(Maths, TheCheckOfMarkupFindsFaults) {
  EXPECT_EQ(test::markup_fault("<a b=\"1\"><c/>x&lt;</a>"), "");
  for (const char* bad :
       {"<a>", "<a></b>", "<a b=1></a>", "<a>&x;</a>", "<a/><b/>", "<mfrac><mi>x</mi></mfrac>", "<a b=\"<\"/>"})
    EXPECT_NE(test::markup_fault(bad), "") << bad;
}

std::vector<Formula> specimen_formulas() {
  std::vector<Formula> formulas;
  for (const TextBlock& block : read_markdown(maths_specimen(), "specimen", 1).blocks)
    for (const TextSpan& span : block.spans)
      if (span.formula) formulas.push_back(*span.formula);
  return formulas;
}

TEST(Maths, EveryFormulaOfTheSpecimenIsWellFormed) {
  const auto formulas = specimen_formulas();
  EXPECT_GT(formulas.size(), 25u);
  for (const Formula& formula : formulas) EXPECT_EQ(test::markup_fault(mathml(formula)), "") << mathml(formula);
}

/// A parser of others, where there is one.
TEST(Maths, XmllintReadsTheSpecimen) {
  if (std::system("xmllint --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no xmllint (Debian: libxml2-utils)";
  const auto path = fresh_output_folder("maths-xmllint") / "specimen.xhtml";
  {
    std::ofstream out(path);
    out << "<html xmlns=\"http://www.w3.org/1999/xhtml\"><body>";
    for (const Formula& formula : specimen_formulas()) out << "<p>" << mathml(formula) << "</p>";
    out << "</body></html>";
  }
  EXPECT_EQ(std::system(("xmllint --noout --nonet '" + path.string() + "'").c_str()), 0);
}

bool uses(std::string_view text, std::string_view command) {
  for (auto at = text.find(command); at != std::string_view::npos; at = text.find(command, at + 1)) {
    const std::size_t end = at + command.size();
    const bool word = std::isalpha(static_cast<unsigned char>(command.back())) != 0;
    if (!word || end >= text.size() || std::isalpha(static_cast<unsigned char>(text[end])) == 0) return true;
  }
  return false;
}

TEST(Maths, TheSpecimenLeavesNothingOut) {
  for (const SignCommand& each : sign_commands())
    EXPECT_TRUE(uses(maths_specimen(), "\\" + std::string(each.name))) << each.name;
  for (const char* structure :
       {"\\frac",   "\\sqrt{", "\\sqrt[",  "\\vec",          "\\hat",     "\\bar",     "\\mathbf",
        "\\mathrm", "\\text",  "\\left",   "\\operatorname", "\\,",       "\\;",       "\\ ",
        "\\quad",   "\\|",     "{matrix}", "{pmatrix}",      "{bmatrix}", "{vmatrix}", "{cases}"})
    EXPECT_NE(maths_specimen().find(structure), std::string_view::npos) << structure;
  for (const char* delimiter : {"(", "[", "\\{", "|", "\\|", "\\lfloor", "\\lceil", "\\langle", "."})
    EXPECT_NE(maths_specimen().find("\\left" + std::string(delimiter)), std::string_view::npos) << delimiter;
}

TEST(Maths, SpacesFollowFromRoles) {
  const auto roles = roles_in(read("-a + (-b)").row);
  ASSERT_EQ(roles.size(), 7u);
  EXPECT_EQ(roles[0], MathsRole::ordinary);
  EXPECT_EQ(roles[2], MathsRole::binary);
  EXPECT_EQ(roles[4], MathsRole::ordinary);
  EXPECT_DOUBLE_EQ(maths_space(MathsRole::ordinary, MathsRole::relation, false), 5.0 / 18);
  EXPECT_DOUBLE_EQ(maths_space(MathsRole::ordinary, MathsRole::relation, true), 0);
  EXPECT_DOUBLE_EQ(maths_space(MathsRole::ordinary, MathsRole::binary, false), 4.0 / 18);
  EXPECT_DOUBLE_EQ(maths_space(MathsRole::function, MathsRole::ordinary, true), 3.0 / 18);
  EXPECT_DOUBLE_EQ(maths_space(MathsRole::function, MathsRole::opening, false), 0);
}

}  // namespace
}  // namespace ps::maths_test
