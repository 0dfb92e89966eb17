#pragma once
#include <optional>
#include <string>
#include <vector>

#include "gui/session/session.h"

namespace ps::gui {

/// Something that can be taken hold of in a picture: a point light, the centre of a sphere, a box or a model, or the
/// corner of a rectangle.
struct Handle {
  std::string path;       ///< of the property it changes, as set_property reads it: "light.1.position"
  std::string name;       ///< for people
  Vec3d position;         ///< world space
  Vec2d place;            ///< in the picture, pixels from the top left, y down; may lie outside it
  bool is_light = false;  ///< drawn as a sun, else as a cross
  Vec3d offset{0, 0, 0};  ///< from `position` to the value of the property
};

/// The handles in front of the camera.
std::vector<Handle> handles_of(const Scene& scene, const View& view, const Settings& settings);

/// Where a point of the world lies in the picture; nullopt for points that are not in front of the camera.
std::optional<Vec2d> place_in_picture(const View& view, const Settings& settings, const Vec3d& point);

/// The world position at a place of the picture that is as far along the camera's forward axis as `like`.
Vec3d position_at(const View& view, const Settings& settings, const Vec3d& like, const Vec2d& place);

/// A place as edits have it: four digits are finer than a pixel and read well in a saved scene.
std::string brief_place(const Vec3d& place);

/// Moves what the handle holds to another place of the picture, at its depth. Moves in a row are one step in the
/// history until Session::end_drag().
void drag_handle(Session& session, Side side, const Handle& handle, const Vec2d& place);

}  // namespace ps::gui
