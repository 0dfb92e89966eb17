#pragma once
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/check.h"

/// Formulas of lessons as trees. They are written in a subset of LaTeX, which chapters/README.md describes; the window
/// typesets them (maths_layout.h), other writers are declared in engine/maths_writers.h.

namespace ps {

enum class MathsStyle { upright, italic, bold };

/// The role of a sign among its neighbours. The space between two of them follows from it (maths_space()).
enum class MathsRole {
  ordinary,
  function,  ///< sin, max, and large operators such as a sum
  binary,    ///< + and the like
  relation,  ///< = and the like
  opening,
  closing,
  punctuation
};

enum class MathsAccent { vector, hat, bar };

struct MathsNode;
/// Parts that are written side by side.
using MathsRow = std::vector<MathsNode>;

/// A letter, a number, the name of a function or any other sign.
struct MathsSign {
  std::string text;  ///< UTF-8
  MathsStyle style = MathsStyle::upright;
  MathsRole role = MathsRole::ordinary;
  bool large = false;   ///< higher in a display formula: sums, products, integrals
  bool limits = false;  ///< in a display formula, scripts are above and below it
};

struct MathsGroup {
  MathsRow inside;
};

/// Sub- and superscript; one of them may be empty.
struct MathsScripts {
  MathsRow base, sub, super;
};

struct MathsFraction {
  MathsRow numerator, denominator;
};

struct MathsRoot {
  MathsRow inside;
  MathsRow degree;  ///< empty: a square root
};

struct MathsAccented {
  MathsAccent accent = MathsAccent::vector;
  MathsRow inside;
};

/// Delimiters as high as what is between them. An empty one is not drawn.
struct MathsFence {
  std::string opening, closing;  ///< UTF-8
  MathsRow inside;
};

enum class MathsAlignment { centre, left };

/// Rows of equally many cells between delimiters, as in a fence.
struct MathsMatrix {
  std::string opening, closing;
  MathsAlignment alignment = MathsAlignment::centre;
  std::vector<std::vector<MathsRow>> rows;
};

/// Words inside a formula.
struct MathsWords {
  std::string text;
};

struct MathsSpace {
  double em = 0;
};

struct MathsNode {
  std::variant<MathsSign, MathsGroup, MathsScripts, MathsFraction, MathsRoot, MathsAccented, MathsFence, MathsMatrix,
               MathsWords, MathsSpace>
      what;
};

enum class FormulaForm {
  in_text,  ///< between single dollar signs
  display   ///< between double ones: a paragraph of its own, set larger
};

struct Formula {
  std::string notation;  ///< as written, without the dollar signs
  FormulaForm form = FormulaForm::in_text;
  MathsRow row;  ///< as read; follows from the notation
  bool operator==(const Formula& other) const { return notation == other.notation && form == other.form; }
};

/// Reads the notation, whose first byte is at `start`. Throws InputError with file, line and column of an unknown
/// command, a sign without meaning, or a brace, script or environment without its partner.
Formula read_formula(std::string_view notation, FormulaForm form, const SourcePlace& start);

/// The role of each node. A binary sign without an operand before it, as in "-1", has the role ordinary.
std::vector<MathsRole> roles_in(const MathsRow& row);

/// The space between neighbours, as TeX has it (Knuth, The TeXbook, chapter 18), in em. In scripts, the spaces around
/// binary signs and relations are left out.
double maths_space(MathsRole left, MathsRole right, bool in_script);

}  // namespace ps
