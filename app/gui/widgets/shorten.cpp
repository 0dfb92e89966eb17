#include "gui/widgets/shorten.h"

#include "gui/widgets/draw.h"

namespace ps::gui {

std::string whole_words(std::string_view text, float width) {
  if (text_width(text) <= width) return std::string(text);
  std::string part(text);
  for (std::size_t end = part.rfind(' '); end != std::string::npos; end = part.rfind(' ')) {
    part.resize(end);
    while (!part.empty() && (part.back() == ',' || part.back() == ':' || part.back() == ' ')) part.pop_back();
    if (text_width(part + " …") <= width) break;
  }
  return part == text ? part : part + " …";
}

}  // namespace ps::gui
