#include "gui/session/pixel_words.h"

#include <fmt/format.h>

#include "math/conventions.h"

namespace ps::gui {

std::string pixel_words(const Session& session, Vec2i pixel) {
  std::string words = fmt::format("x {}, y {}", pixel.x, pixel.y);
  if (session.document().lesson.empty()) return words;
  const View view = session.view();
  const Vec2i book = book_pixel(pixel.x, pixel.y, view.width, view.height);
  return words + fmt::format("   book ({}, {})", book.x, book.y);
}

}  // namespace ps::gui
