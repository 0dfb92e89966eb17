#include "gui/widgets/maths_draw.h"

#include <imgui_internal.h>  // ImTextCharFromUtf8

#include <algorithm>
#include <cmath>

namespace ps::gui {

MathsFaces maths_faces(Face text) {
  if (text != Face::caption) return {};
  // The sizes below the caption's 24 are 17, which is its .7, and the semi-bold weight is the caption's own.
  return {Face::caption, Face::caption_italic, Face::caption, Face::bold, Face::italic, Face::bold};
}

Face WindowMathsFont::face(MathsStyle style, MathsSize size) const {
  const bool script = size == MathsSize::script;
  switch (style) {
  case MathsStyle::upright:
    return script ? faces_.script : faces_.upright;
  case MathsStyle::italic:
    return script ? faces_.script_italic : faces_.italic;
  case MathsStyle::bold:
    return script ? faces_.script_bold : faces_.bold;
  }
  return faces_.upright;
}

float WindowMathsFont::em(MathsSize size) const { return px(type_size(face(MathsStyle::upright, size))); }

InkBox WindowMathsFont::ink(MathsStyle style, MathsSize size, std::string_view utf8) const {
  ImFont& font = *theme().font(face(style, size));
  InkBox box{0, 1e6f, -1e6f, -1e6f, -1e6f};
  const char* const end = utf8.data() + utf8.size();
  for (const char* at = utf8.data(); at < end;) {
    unsigned code = 0;
    at += std::max(1, ImTextCharFromUtf8(&code, at, end));
    const ImFontGlyph* glyph = font.FindGlyph(static_cast<ImWchar>(code));
    if (!glyph) continue;
    if (glyph->Visible) {
      box.left = std::min(box.left, box.advance + glyph->X0);
      box.right = std::max(box.right, box.advance + glyph->X1);
      box.above = std::max(box.above, font.Ascent - glyph->Y0);
      box.below = std::max(box.below, glyph->Y1 - font.Ascent);
    }
    box.advance += glyph->AdvanceX;
  }
  if (box.right < box.left) return {box.advance, 0, 0, 0, 0};
  return box;
}

float ascent_of(Face face) { return theme().font(face)->Ascent; }

void draw_maths(ImDrawList& list, ImVec2 origin, const MathsBox& box, const WindowMathsFont& font,
                const ImVec4& colour) {
  const ImU32 ink = colour_u32(colour);
  for (const MathsText& text : box.texts) {
    const Face face = font.face(text.style, text.size);
    ImFont* used = theme().font(face);
    // Dear ImGui rounds down to whole pixels, so that glyphs are sharp; here to the nearest ones.
    const ImVec2 at{std::round(origin.x + text.x), std::round(origin.y + text.y - used->Ascent)};
    list.AddText(used, used->FontSize, at, ink, text.text.data(), text.text.data() + text.text.size());
  }
  for (const MathsStroke& stroke : box.strokes) {
    std::vector<ImVec2> points;
    points.reserve(stroke.points.size());
    for (const MathsPoint& point : stroke.points) points.push_back({origin.x + point.x, origin.y + point.y});
    list.AddPolyline(points.data(), static_cast<int>(points.size()), ink, ImDrawFlags_None, stroke.thickness);
  }
  for (const MathsRule& rule : box.rules) {
    const float x = std::round(origin.x + rule.x), y = std::round(origin.y + rule.y);
    list.AddRectFilled({x, y}, {std::round(x + rule.width), y + rule.height}, ink);
  }
}

}  // namespace ps::gui
