#include "scene/object_boxes.h"

#include <variant>

#include "base/stop.h"
#include "math/unit.h"
#include "scene/world.h"

namespace ps {
namespace {

/// Around the vertices that triangles use.
FormBox box_of_used(const Mesh& mesh) {
  FormBox box;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % 4096 == 4095) check_stop();
    for (const std::uint32_t corner : mesh.triangles[i].position) include_point(box, mesh.positions[corner]);
  }
  return box;
}

Vec3d corner_of(const FormBox& box, int corner) {
  return {((corner & 1) != 0 ? box.high : box.low).x, ((corner & 2) != 0 ? box.high : box.low).y,
          ((corner & 4) != 0 ? box.high : box.low).z};
}

class BoxesOfObjects {
 public:
  explicit BoxesOfObjects(const Geometry& geometry) : geometry_(geometry), meshes_(geometry_.meshes.size()) {
    for (const Object& object : geometry_.objects) {
      check_stop();
      boxes.push_back(std::visit([&](const auto& shape) { return box_of(shape); }, object.shape));
    }
  }
  std::vector<FormBox> boxes;

 private:
  static FormBox box_of(const Sphere& sphere) { return {sphere.centre - sphere.radius, sphere.centre + sphere.radius}; }
  static FormBox box_of(const Solid& solid) {
    const auto* plane = std::get_if<Plane>(&solid.form);
    if (!plane) return solid_box(solid);
    const Vec3d point = solid.place.linear * plane->point + solid.place.translation;
    return {point, point};
  }
  static FormBox box_of(const Csg& csg) { return csg_box(csg.root); }
  FormBox box_of(const Instance& instance) {
    FormBox& own = meshes_[instance.mesh];
    if (!is_bounded(own)) own = box_of_used(*geometry_.meshes[instance.mesh]);
    FormBox box;
    if (is_bounded(own))  // it has triangles
      for (int corner = 0; corner < 8; ++corner)
        include_point(box, ps::to_world(instance.transform, corner_of(own, corner)));
    return box;
  }

  const Geometry& geometry_;
  std::vector<FormBox> meshes_;  ///< by mesh; unbounded: not asked for yet
};

}  // namespace

std::vector<FormBox> boxes_of_objects(const Geometry& geometry) { return BoxesOfObjects(geometry).boxes; }

void include_point(FormBox& box, const Vec3d& point) {
  box.low = glm::min(box.low, point);
  box.high = glm::max(box.high, point);
}

double distance_to(const FormBox& box, const Vec3d& point) {
  return length_of(glm::max(glm::max(box.low - point, point - box.high), Vec3d(0)));
}

}  // namespace ps
