#include "gui/frame/drop.h"

#include "base/check.h"
#include "document/permalink_file.h"

namespace ps::gui {
namespace {

/// The object that is seen at a place of the window, else that of the picked pixel; -1 = none.
int object_at(Session& session, const PicturesState& pictures, ImVec2 place) {
  const auto seen = [&](Side side, Vec2i pixel) {
    const auto result = session.renderer(side).result();
    const bool known = result && has(result->channels, Channel::ids) && result->frame.ids.contains(pixel.x, pixel.y);
    return known ? result->frame.ids.at(pixel.x, pixel.y).object : -1;
  };
  for (const Side side : both_sides)
    if (const auto& area = pictures.drawn.areas[index_of(side)]; area && area->contains(place))
      if (const int object = seen(side, pictures.drawn.transform.pixel_at(place, *area)); object >= 0) return object;
  const auto picked = session.pixel();
  return picked ? seen(inspected_side(session), *picked) : -1;
}

}  // namespace

void take_dropped_file(Session& session, const PicturesState& pictures, DroppedPicture& dropped,
                       const std::string& path, WindowPoint at) {
  if (!session.has_scene() || !is_picture_file(path)) return session.open(path);
  try {
    if (permalink_in_file(path)) return session.open(path);
  } catch (const InputError&) {
    return session.open(path);  // says what is wrong with it
  }
  dropped.ask(path, object_at(session, pictures, {at.x, at.y}));
}

}  // namespace ps::gui
