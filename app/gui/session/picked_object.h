#pragma once
#include <optional>
#include <string>

#include "gui/session/session.h"

namespace ps::gui {

/// The object that is edited: what the picked pixel showed when it was picked. It stays when it is moved away from that
/// pixel, until another pixel or scene is picked.
class PickedObject {
 public:
  /// Once a frame: takes up another pixel as soon as its story is there.
  void update(const Session& session);
  /// Another object of the scene in place of the pixel's: `by` on in the scene's order, round and round.
  void step(const Session& session, int by);
  /// Another one in place of the pixel's, which may be one that has just been added; nullopt = none.
  void choose(std::optional<std::size_t> object) { object_ = object; }
  /// Index into Geometry::objects; nullopt while none is picked, or where the scene no longer has it.
  std::optional<std::size_t> index(const Session& session) const;

 private:
  std::optional<std::size_t> object_;
  std::optional<Vec2i> pixel_;
  Side side_ = Side::a;
  std::string scene_;
};

/// The object that gizmos and numbers act on, wherever they are shown.
struct ObjectSelection {
  PickedObject object;
  bool gizmo = false;  ///< it can be moved, turned and scaled where it is shown
};

}  // namespace ps::gui
