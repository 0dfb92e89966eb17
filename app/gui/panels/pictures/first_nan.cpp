#include "gui/panels/pictures/first_nan.h"

#include <fmt/format.h>

#include "math/has_nan.h"

namespace ps::gui {
std::optional<Vec2i> first_not_finite(const Image<Vec3f>& colour) {
  for (int y = 0; y < colour.height(); ++y)
    for (int x = 0; x < colour.width(); ++x)
      if (!is_finite(colour.at(x, y))) return Vec2i(x, y);
  return {};
}

void go_to_first_nan(Session& session) {
  if (session.work().rendering())
    return session.say(Message::Kind::information, "A picture is still being made: its pixels are not known yet.");
  const Side picked = session.document().picked;
  for (const Side side : {picked, other_side(picked)}) {
    if (session.file_of(side)) continue;  // levels of a file are finite
    const auto result = session.renderer(side).result();
    const auto found = result ? first_not_finite(result->frame.colour) : std::nullopt;
    if (!found) continue;
    session.set_pixel(*found);
    session.navigate([&](Document& document) { document.picked = side; });
    const bool nan = has_nan(result->frame.colour.at(found->x, found->y));
    return session.say(Message::Kind::information,
                       fmt::format("{}: the first pixel that is {} is ({}, {}).", letter_of(side),
                                   nan ? "not a number" : "infinite", found->x, found->y));
  }
  session.say(Message::Kind::information, "All pixels of A and of B are finite.");
}

}  // namespace ps::gui
