#pragma once
#include <imgui.h>

#include "engine/maths_box.h"
#include "gui/theme/theme.h"

namespace ps::gui {

/// The faces in which the formulas of a text are set.
struct MathsFaces {
  Face upright = Face::body, italic = Face::italic, bold = Face::bold;
  Face script = Face::script, script_italic = Face::script_italic, script_bold = Face::script_bold;
};

/// For text in this face: the body faces, or those of the presenter's caption.
MathsFaces maths_faces(Face text);

/// The window's own fonts, measured as they are drawn.
class WindowMathsFont : public MathsFont {
 public:
  explicit WindowMathsFont(const MathsFaces& faces) : faces_(faces) {}
  InkBox ink(MathsStyle style, MathsSize size, std::string_view utf8) const override;
  float em(MathsSize size) const override;
  Face face(MathsStyle style, MathsSize size) const;

 private:
  MathsFaces faces_;
};

/// Draws a formula with the left end of its baseline at `origin`.
void draw_maths(ImDrawList& list, ImVec2 origin, const MathsBox& box, const WindowMathsFont& font,
                const ImVec4& colour);

/// Where the baseline of a line of text in this face lies below the line's upper edge, as AddText draws it.
float ascent_of(Face face);

}  // namespace ps::gui
