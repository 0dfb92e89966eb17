// What becomes of files that are dropped on the window.
#include <imgui.h>

#include "base/check.h"
#include "document/permalink_file.h"
#include "gui/frame/app.h"

namespace ps::gui {

int App::object_at(ImVec2 place) {
  const auto seen = [&](Side side, Vec2i pixel) {
    const auto result = session_.renderer(side).result();
    const bool known = result && has(result->channels, Channel::ids) && result->frame.ids.contains(pixel.x, pixel.y);
    return known ? result->frame.ids.at(pixel.x, pixel.y).object : -1;
  };
  for (const Side side : both_sides)
    if (const auto& area = pictures_.areas[index_of(side)]; area && area->contains(place))
      if (const int object = seen(side, pictures_.transform.pixel_at(place, *area)); object >= 0) return object;
  const auto picked = session_.pixel();
  return picked ? seen(inspected_side(session_), *picked) : -1;
}

void App::drop(const std::string& path, std::optional<WindowPoint> at) {
  // A picture that carries a permalink opens what it shows.
  if (!session_.has_scene() || !is_picture_file(path)) return session_.open(path);
  try {
    if (const auto link = permalink_in_file(path)) return session_.open_permalink(*link);
  } catch (const InputError& error) {
    return session_.say(Message::Kind::error, error.what());
  }
  const ImVec2 place = at ? ImVec2{at->x, at->y} : ImGui::GetIO().MousePos;
  ask_about_picture(session_, dropped_, path, object_at(place));
}

}  // namespace ps::gui
