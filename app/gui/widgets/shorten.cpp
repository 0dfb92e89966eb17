#include "gui/widgets/shorten.h"

#include <algorithm>
#include <vector>

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

std::string whole_parts(std::string_view text, float width) {
  if (text_width(text) <= width) return std::string(text);
  for (const auto& dividers : {std::vector<std::string_view>{", ", " · "}, std::vector<std::string_view>{" "}}) {
    std::string part(text);
    while (true) {
      std::size_t end = std::string::npos;
      for (const std::string_view divider : dividers)
        if (const std::size_t at = part.rfind(divider); at != std::string::npos)
          end = end == std::string::npos ? at : std::max(end, at);
      if (end == std::string::npos) break;
      part.resize(end);
      if (text_width(part + " …") <= width) return part + " …";
    }
  }
  return std::string(text);
}

}  // namespace ps::gui
