#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "engine/maths.h"

/// Typeset formulas as geometry: what lies where, without a window. Lengths are window pixels, x to the right from the
/// left end, y down from the baseline.
namespace ps {

/// The two sizes in a formula: that of the text around it, and that of scripts.
enum class MathsSize { text, script };

/// Extent of a text that is drawn from (0, 0) on its baseline.
struct InkBox {
  float advance = 0;           ///< where what follows begins
  float left = 0, right = 0;   ///< of its ink
  float above = 0, below = 0;  ///< of its ink, both positive away from the baseline
};

/// What typesetting needs to know of a font.
class MathsFont {
 public:
  virtual ~MathsFont() = default;
  virtual InkBox ink(MathsStyle style, MathsSize size, std::string_view utf8) const = 0;
  /// Pixels of the em at this size.
  virtual float em(MathsSize size) const = 0;
};

struct MathsText {
  float x = 0, y = 0;  ///< of the left end of its baseline
  std::string text;
  MathsStyle style = MathsStyle::upright;
  MathsSize size = MathsSize::text;
};

struct MathsPoint {
  float x = 0, y = 0;
};

/// An open line of this thickness.
struct MathsStroke {
  std::vector<MathsPoint> points;
  float thickness = 1;
};

/// A filled rectangle: bars of fractions and roots.
struct MathsRule {
  float x = 0, y = 0, width = 0, height = 0;
};

struct MathsBox {
  float width = 0, above = 0, below = 0;
  std::vector<MathsText> texts;
  std::vector<MathsStroke> strokes;
  std::vector<MathsRule> rules;

  float height() const { return above + below; }
  /// Adds what is in `other`, moved; its extent above and below counts, its width does not.
  void add(const MathsBox& other, float x, float y = 0);
};

}  // namespace ps
