#include <cmath>

#include <fmt/format.h>

#include "math/unit.h"
#include "scene/rotation.h"
#include "scene/scene_draft.h"

namespace ps {
namespace {

/// A frame that looks at a point. Right and up are perpendicular to the view whatever `up` is.
void look_at(const SceneSource& source, const SceneFields& fields, Camera& camera) {
  const SceneValues& values = source.values;
  const SceneTerm& target = fields.require("look_at");
  const Vec3d towards = values.vec3(target) - camera.position;
  if (towards == Vec3d{0, 0, 0}) values.fail(target, "a point other than the camera's position");
  const SceneTerm* up_term = fields.find("up");
  const Vec3d up = up_term != nullptr ? values.direction(*up_term) : Vec3d{0, 1, 0};
  bool right_handed = false;
  if (const SceneTerm* term = fields.find("handedness")) {
    const std::string hand = values.name(*term, "left or right");
    if (hand != "left" && hand != "right") values.fail(*term, "left or right");
    right_handed = hand == "right";
  }
  camera.forward = unit_of(towards);
  const Vec3d across = right_handed ? cross(camera.forward, up) : cross(up, camera.forward);
  if (!(dot(across, across) > 1e-24 * dot(up, up)))
    values.fail(up_term != nullptr ? *up_term : target, "an 'up' that is not the direction of view");
  camera.right = unit_of(across);
  camera.up = right_handed ? cross(camera.right, camera.forward) : cross(camera.forward, camera.right);
}

}  // namespace

void read_camera(const SceneSource& source, const SceneEntry& entry, SceneDraft& draft) {
  const SceneValues& values = source.values;
  const SceneFields fields(values, entry, {"position", "rotation", "look_at", "up", "handedness", "right", "forward"});
  Camera& camera = draft.scene.camera;
  if (const auto* term = fields.find("position")) camera.position = values.vec3(*term);
  if (fields.find("look_at") != nullptr) {
    fields.forbid({"rotation", "right", "forward"}, "only one of 'look_at', 'rotation' and 'right'");
    return look_at(source, fields, camera);
  }
  fields.forbid({"handedness"}, "'handedness' beside 'look_at' only");
  if (const auto* term = fields.find("rotation")) {
    fields.forbid({"right", "up", "forward"}, "only one of 'look_at', 'rotation' and 'right'");
    const Mat3d rotation = values.frame(*term);
    camera.right = rotation[0];
    camera.up = rotation[1];
    camera.forward = rotation[2];
    return;
  }
  if (fields.find("right") == nullptr && fields.find("up") == nullptr && fields.find("forward") == nullptr) return;
  camera.right = values.camera_axis(fields.require("right"));
  camera.up = values.camera_axis(fields.require("up"));
  camera.forward = values.camera_axis(fields.require("forward"));
}

}  // namespace ps
