#include "gui/panels/pictures/clipped_text.h"

#include <algorithm>
#include <cfloat>
#include <vector>

#include "gui/base/fit.h"

namespace ps::gui {

float width_of(Face face, const std::string& text) {
  ImFont* font = theme().font(face);
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x;
}

std::string whole_parts(Face face, const std::string& text, float width) {
  if (width_of(face, text) <= width) return text;
  for (const auto& dividers : {std::vector<std::string>{", ", " · "}, std::vector<std::string>{" "}}) {
    std::string part = text;
    while (true) {
      std::size_t end = std::string::npos;
      for (const std::string& divider : dividers)
        if (const std::size_t at = part.rfind(divider); at != std::string::npos)
          end = end == std::string::npos ? at : std::max(end, at);
      if (end == std::string::npos) break;
      part.resize(end);
      if (width_of(face, part + " …") <= width) return part + " …";
    }
  }
  return text;
}

void clipped_text(ImDrawList& list, Face face, ImVec2 at, float width, ImU32 colour, std::string text) {
  ImFont* font = theme().font(face);
  if (width_of(face, text) > width) {
    fit_watch().shortened(at, {at.x + width, at.y + font->FontSize}, text);
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
