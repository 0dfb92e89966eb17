#include "gui/session/picked_object.h"

#include "inspect/predict.h"

namespace ps::gui {

void PickedObject::update(const Session& session) {
  if (!session.has_scene()) return;
  const Document& document = session.document();
  if (scene_ != document.scene_name) {
    object_.reset();
    pixel_.reset();
    scene_ = document.scene_name;
  }
  const auto pixel = session.pixel();
  const Side side = inspected_side(session);
  if (!pixel || (pixel == pixel_ && side == side_)) return;
  const auto story = session.story(side);
  if (!story || story->pixel != *pixel) return;
  pixel_ = pixel;
  side_ = side;
  const int winner = winner_of(*story);
  object_ = winner >= 0 ? std::optional(static_cast<std::size_t>(winner)) : std::nullopt;
}

void PickedObject::step(const Session& session, int by) {
  const auto count = static_cast<int>(session.scene().geometry->objects.size());
  if (count == 0) return;
  const auto now = index(session);
  const int next = now ? static_cast<int>(*now) + by : by > 0 ? 0 : count - 1;
  object_ = static_cast<std::size_t>((next % count + count) % count);
}

std::optional<std::size_t> PickedObject::index(const Session& session) const {
  if (!object_ || !session.has_scene() || *object_ >= session.scene().geometry->objects.size()) return {};
  return object_;
}

}  // namespace ps::gui
