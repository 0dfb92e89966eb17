#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "document/scene_edits.h"
#include "frame/view.h"
#include "gui/session/session.h"

namespace ps::gui {

enum class GizmoDeed { move, turn, scale };
/// "move", "turn" or "scale"
std::string_view deed_word(GizmoDeed deed);

/// One thing to take hold of: what it does, and along or about which axis.
struct GizmoPart {
  GizmoDeed deed = GizmoDeed::move;
  std::size_t axis = 0;
  bool operator==(const GizmoPart&) const = default;
};

/// What can be moved, turned or scaled where it is seen: an object of the scene, or the picture's camera.
struct Gizmo {
  std::optional<std::size_t> object;  ///< index into Geometry::objects; nothing: the camera
  std::string name;                   ///< for people
  Vec3d centre{0, 0, 0};              ///< world space
  std::array<Vec3d, 3> axes{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};  ///< its own, of length 1, world space
  bool turns = false, scales = false;
};

/// The gizmo of an object; nullopt for CSG objects, whose parts have places of their own, and for objects that are not
/// in the scene.
std::optional<Gizmo> gizmo_of(const Scene& scene, std::size_t object);
Gizmo gizmo_of(const Camera& camera);

/// How something is seen: by the picture's camera, or from outside.
struct Sight {
  View view;
  Settings settings;
};

/// World units that are `pixels` wide at the depth of a point; nullopt for points that are not in front of the camera.
std::optional<double> world_length(const Sight& sight, const Vec3d& at, double pixels);

/// A drag as it began. All that follows is computed from there, so that its steps leave no rounding errors behind.
struct GizmoDrag {
  Gizmo gizmo;
  GizmoPart part;
  Sight sight;
  Vec2d from{0, 0};  ///< in the picture, pixels from the top left
  double reach = 1;  ///< length of the gizmo's axes, world units
  Scene scene;
  Camera camera;  ///< the picture's
};

/// How far a drag to a place of the picture goes: world units along the axis, radians about it, or a factor. nullopt
/// where the place says nothing about the axis, which may point at the eye.
std::optional<double> gizmo_travel(const GizmoDrag& drag, const Vec2d& to);

/// What moves, turns or scales the drag's object by that much, as edits of its scene. Not for the camera.
std::vector<SceneEdit> gizmo_edits(const GizmoDrag& drag, double travel);

/// The drag's camera, moved or turned by that much.
Camera dragged_camera(const GizmoDrag& drag, double travel);

/// Carries the drag on to a place of the picture. All of it is one step in the history until Session::end_drag(), and
/// none after Session::cancel_drag(gizmo_step).
void drag_gizmo(Session& session, const GizmoDrag& drag, const Vec2d& to);
inline constexpr const char* gizmo_step = "gizmo";

}  // namespace ps::gui
