#include "gui/session/gizmo_shapes.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <memory>

#include "base/overloaded.h"
#include "math/unit.h"
#include "scene/form_frame.h"
#include "scene/mesh.h"
#include "scene/scene_text.h"

namespace ps::gui {
namespace {

/// Five digits are finer than a pixel and read well in a saved scene.
std::string short_vec(const Vec3d& v) { return fmt::format("({:.5g}, {:.5g}, {:.5g})", v.x, v.y, v.z); }

/// The columns of a rotation at length 1; the world's axes where one has no direction.
std::array<Vec3d, 3> axes_of(const Mat3d& rotation) {
  std::array<Vec3d, 3> axes{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
  for (int i = 0; i < 3; ++i)
    if (dot(rotation[i], rotation[i]) > 0) axes[static_cast<std::size_t>(i)] = unit_of(rotation[i]);
  return axes;
}

Vec3d centre_of(const std::shared_ptr<const Mesh>& mesh) {
  static std::map<std::weak_ptr<const Mesh>, Vec3d, std::owner_less<>> known;
  if (const auto found = known.find(mesh); found != known.end()) return found->second;
  std::erase_if(known, [](const auto& entry) { return entry.first.expired(); });
  return known[mesh] = bounding_sphere(*mesh).centre;
}

Vec3d mesh_centre(const Scene& scene, const Instance& instance) {
  return centre_of(scene.geometry->meshes.at(instance.mesh));
}

Vec3d centre_of(const Form& form) {
  return std::visit(Overloaded{[](const Ball& ball) { return ball.centre; },
                               [](const Plane& plane) { return plane.point; },
                               [](const Rectangle& r) { return r.corner + (r.side_a + r.side_b) * 0.5; },
                               [](const Brick& brick) { return brick.centre; },
                               [](const Cylinder& c) { return (c.from + c.to) * 0.5; }},
                    form);
}

/// What one drag does to an object of the scene as it was.
class Edits {
 public:
  explicit Edits(const GizmoDrag& drag, double travel)
      : drag_(drag), travel_(travel), axis_(drag.gizmo.axes[drag.part.axis]) {}

  std::vector<SceneEdit> take() { return std::move(edits_); }

  void sphere(const Sphere& sphere) {
    if (moves()) set("center", short_vec(sphere.centre + step()));
    if (scales()) set("radius", fmt::format("{:.5g}", sphere.radius * travel_));
  }
  void instance(const Instance& instance) {
    const Transform& place = instance.transform;
    if (moves()) set("translation", short_vec(place.translation + step()));
    if (turns()) {
      set("rotation", scene_rotation(rotation() * place.rotation));
      set("translation", short_vec(about_centre(place.translation)));
    }
    if (scales()) {
      // What is in the middle stays there.
      Vec3d scale = place.scale;
      scale[static_cast<int>(drag_.part.axis)] *= travel_;
      set("scale", short_vec(scale));
      set("translation", short_vec(drag_.gizmo.centre - place.rotation * (scale * mesh_centre(drag_.scene, instance))));
    }
  }
  void solid(const Solid& solid) {
    // The form's numbers are in the space before its place, which a group gave it.
    const Vec3d by = moves() ? glm::inverse(solid.place.linear) * step() : Vec3d(0, 0, 0);
    std::visit(Overloaded{[&](const Ball& ball) {
                            if (moves()) set("center", short_vec(ball.centre + by));
                            if (scales()) set("radius", fmt::format("{:.5g}", ball.radius * travel_));
                          },
                          [&](const Plane& plane) {
                            if (moves()) set("point", short_vec(plane.point + by));
                            if (turns()) set("normal", scene_vec(rotation() * plane.normal));
                          },
                          [&](const Rectangle& rectangle) {
                            if (moves()) set("corner", short_vec(rectangle.corner + by));
                          },
                          [&](const Brick& brick) { this->brick(brick, by); },
                          [&](const Cylinder& cylinder) { this->cylinder(cylinder, by); }},
               solid.form);
  }

 private:
  bool moves() const { return drag_.part.deed == GizmoDeed::move; }
  bool turns() const { return drag_.part.deed == GizmoDeed::turn; }
  bool scales() const { return drag_.part.deed == GizmoDeed::scale; }
  Vec3d step() const { return axis_ * travel_; }
  Mat3d rotation() const { return Mat3d(glm::rotate(Mat4d(1.0), travel_, axis_)); }
  Vec3d about_centre(const Vec3d& point) const {
    return drag_.gizmo.centre + rotation() * (point - drag_.gizmo.centre);
  }
  void set(const char* name, std::string value) {
    edits_.push_back({fmt::format("object.{}.{}", *drag_.gizmo.object, name), std::move(value)});
  }

  void brick(const Brick& brick, const Vec3d& by) {
    if (moves()) set("center", short_vec(brick.centre + by));
    if (turns()) set("rotation", scene_rotation(rotation() * brick.rotation));
    if (scales()) {
      Vec3d size = brick.size;
      size[static_cast<int>(drag_.part.axis)] *= travel_;
      set("size", short_vec(size));
    }
  }
  void cylinder(const Cylinder& cylinder, const Vec3d& by) {
    if (moves()) {
      set("from", short_vec(cylinder.from + by));
      set("to", short_vec(cylinder.to + by));
    }
    if (turns()) {
      set("from", short_vec(about_centre(cylinder.from)));
      set("to", short_vec(about_centre(cylinder.to)));
    }
    if (scales()) set("radius", fmt::format("{:.5g}", cylinder.radius * travel_));
  }

  const GizmoDrag& drag_;
  double travel_;
  Vec3d axis_;
  std::vector<SceneEdit> edits_;
};

}  // namespace

Vec3d centre_of(const Scene& scene, const Instance& instance) {
  const Transform& place = instance.transform;
  return place.rotation * (place.scale * mesh_centre(scene, instance)) + place.translation;
}

bool place_gizmo(const Scene& scene, std::size_t object, Gizmo& gizmo) {
  const auto& shape = scene.geometry->objects.at(object).shape;
  if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    gizmo.centre = sphere->centre;
    gizmo.scales = true;
    return true;
  }
  if (const auto* instance = std::get_if<Instance>(&shape)) {
    gizmo.centre = centre_of(scene, *instance);
    gizmo.axes = axes_of(instance->transform.rotation);
    gizmo.turns = gizmo.scales = true;
    return true;
  }
  const auto* solid = std::get_if<Solid>(&shape);
  if (!solid) return false;
  const PartPlace& place = solid->place;
  gizmo.centre = place.linear * centre_of(solid->form) + place.translation;
  // Under a map that may stretch it, a body has no rotation and no size of its own.
  if (!place.is_identity()) return true;
  const bool is_brick = std::holds_alternative<Brick>(solid->form);
  const bool is_cylinder = std::holds_alternative<Cylinder>(solid->form);
  if (is_brick || is_cylinder) gizmo.axes = form_frame(solid->form).axes;
  gizmo.turns = is_brick || is_cylinder || std::holds_alternative<Plane>(solid->form);
  gizmo.scales = is_brick || is_cylinder || std::holds_alternative<Ball>(solid->form);
  return true;
}

std::vector<SceneEdit> gizmo_edits(const GizmoDrag& drag, double travel) {
  Edits edits(drag, travel);
  std::visit(Overloaded{[&](const Sphere& sphere) { edits.sphere(sphere); },
                        [&](const Instance& instance) { edits.instance(instance); },
                        [&](const Solid& solid) { edits.solid(solid); }, [](const Csg&) {}},
             drag.scene.geometry->objects.at(*drag.gizmo.object).shape);
  return edits.take();
}

}  // namespace ps::gui
