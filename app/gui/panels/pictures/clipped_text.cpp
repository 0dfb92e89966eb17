#include "gui/panels/pictures/clipped_text.h"

#include <cfloat>

namespace ps::gui {

float width_of(Face face, const std::string& text) {
  ImFont* font = theme().font(face);
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x;
}

void clipped_text(ImDrawList& list, Face face, ImVec2 at, float width, ImU32 colour, std::string text) {
  ImFont* font = theme().font(face);
  if (width_of(face, text) > width) {
    const auto is_continuation = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
    while (!text.empty() && width_of(face, text + "...") > width) {
      while (!text.empty() && is_continuation(text.back())) text.pop_back();
      if (!text.empty()) text.pop_back();
    }
    text += "...";
  }
  list.AddText(font, font->FontSize, at, colour, text.c_str());
}

}  // namespace ps::gui
