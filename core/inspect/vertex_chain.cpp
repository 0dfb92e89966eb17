#include "inspect/vertex_chain.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/check.h"
#include "raster/base/clip.h"
#include "raster/setup/projection.h"

namespace ps {
namespace {

Mat4d translation_of(const Vec3d& by) {
  Mat4d m(1.0);
  m[3] = {by, 1};
  return m;
}

Mat4d scale_of(const Vec3d& by) {
  Mat4d m(1.0);
  for (int i = 0; i < 3; ++i) m[i][i] = by[i];
  return m;
}

/// Rotation times scale, as the draw list has it.
Mat3d linear_of(const Transform& t) {
  return Mat3d(t.rotation[0] * t.scale.x, t.rotation[1] * t.scale.y, t.rotation[2] * t.scale.z);
}

Vec3d model_to_world(const Transform& t, ModelOrder order, const Vec3d& model) {
  switch (order) {
  case ModelOrder::turn_then_move:
    return linear_of(t) * model + t.translation;
  case ModelOrder::move_then_turn:
    return t.rotation * (t.scale * model + t.translation);
  }
  return model;
}

const Instance& instance_of(const Scene& scene, const VertexId& id) {
  const auto& objects = scene.geometry->objects;
  const auto object = static_cast<std::size_t>(id.object);
  if (id.object < 0 || object >= objects.size())
    throw InputError(fmt::format("vertex: found object {}, expected one of 0 to {}", id.object,
                                 static_cast<std::ptrdiff_t>(objects.size()) - 1));
  const auto* instance = std::get_if<Instance>(&objects[object].shape);
  if (!instance)
    throw InputError(fmt::format("vertex: '{}' is not a model, so it has no vertices", objects[object].name));
  const auto& positions = scene.geometry->meshes[instance->mesh]->positions;
  if (id.vertex < 0 || static_cast<std::size_t>(id.vertex) >= positions.size())
    throw InputError(fmt::format("vertex: found {} of '{}', expected one of 0 to {}", id.vertex, objects[object].name,
                                 static_cast<std::ptrdiff_t>(positions.size()) - 1));
  return *instance;
}

/// As the vertex stage does it: camera-relative positions are rounded to Real last, others first.
template <class Real>
Vec3<Real> camera_point(const raster::CameraSpace& space, const Settings& settings, const Vec3d& world) {
  if (settings.camera_relative) return Vec3<Real>(space.point(world));
  return Vec3<Real>(space.from_world * Vec3d(Vec3<Real>(world) - Vec3<Real>(space.position)));
}

template <class Real>
void follow(const View& view, const Settings& settings, VertexChain& chain) {
  const raster::CameraSpace space = raster::make_camera_space(view.camera);
  const Viewport<double> viewport = make_viewport<double>(view, settings);
  const auto projection = raster::make_canvas_projection<Real>(viewport);
  const Vec3<Real> camera = camera_point<Real>(space, settings, chain.world);
  chain.camera = Vec3d(camera);
  chain.to_camera = Mat4d(space.from_world) * translation_of(-space.position);

  // Clip space: one matrix, and a last coordinate to divide by.
  const bool perspective = projection.kind == Projection::perspective;
  chain.to_clip = Mat4d(1.0);
  chain.to_clip[0][0] = static_cast<double>(projection.scale.x);
  chain.to_clip[1][1] = static_cast<double>(projection.scale.y);
  chain.to_clip[2][3] = perspective ? 1 : 0;
  chain.to_clip[3][3] = perspective ? 0 : 1;
  chain.clip = chain.to_clip * Vec4d(chain.camera, 1);
  for (const auto& plane : raster::make_clip_planes<Real>(settings, viewport)) {
    const auto distance = static_cast<double>(plane.distance(camera));
    chain.planes.push_back({plane.name, distance});
    chain.inside = chain.inside && distance >= 0;
  }
  const double shrink = perspective ? viewport.distance / chain.camera.z : 1.0;
  chain.viewport = {chain.camera.x * shrink, chain.camera.y * shrink};
  chain.centred = Vec2d(projection.centred(camera));
  chain.canvas = Vec2d(projection.from_top_left(camera));
}

/// Keeps the vertex that is seen nearest to a place.
class NearestVertex {
 public:
  NearestVertex(const View& view, const Settings& settings, const Vec2d& place)
      : space_(raster::make_camera_space(view.camera)),
        projection_(raster::make_canvas_projection<double>(make_viewport<double>(view, settings))), place_(place) {}

  void offer(const VertexId& id, const Vec3d& world) {
    const Vec3d camera = space_.point(world);
    if (projection_.kind == Projection::perspective && !(camera.z > 0)) return;
    const Vec2d apart = projection_.from_top_left(camera) - place_;
    const double distance = apart.x * apart.x + apart.y * apart.y;
    if (!(distance < distance_ || (distance == distance_ && camera.z < z_))) return;
    distance_ = distance;
    z_ = camera.z;
    best_ = id;
  }
  std::optional<VertexId> best() const { return best_; }

 private:
  raster::CameraSpace space_;
  raster::CanvasProjection<double> projection_;
  Vec2d place_;
  double distance_ = std::numeric_limits<double>::infinity(), z_ = 0;
  std::optional<VertexId> best_;
};

}  // namespace

VertexChain vertex_chain(const Scene& scene, const View& view, const Settings& settings, const VertexId& id,
                         const VertexEdits& edits) {
  const Instance& instance = instance_of(scene, id);
  const Transform& t = instance.transform;
  VertexChain chain;
  chain.id = id;
  chain.object_name = scene.geometry->objects[static_cast<std::size_t>(id.object)].name;
  chain.model = scene.geometry->meshes[instance.mesh]->positions[static_cast<std::size_t>(id.vertex)];
  chain.scale = scale_of(t.scale);
  chain.rotation = Mat4d(t.rotation);
  chain.translation = translation_of(t.translation);
  chain.to_world = edits.order == ModelOrder::turn_then_move ? chain.translation * chain.rotation * chain.scale
                                                             : chain.rotation * chain.translation * chain.scale;
  chain.world = model_to_world(t, edits.order, chain.model);
  Settings used = settings;
  if (edits.near) used.near = *edits.near;
  if (settings.precision == Precision::float64)
    follow<double>(view, used, chain);
  else
    follow<float>(view, used, chain);
  return chain;
}

std::optional<VertexId> nearest_vertex(const Scene& scene, const View& view, const Settings& settings,
                                       const Vec2d& place, const PixelId& triangle) {
  NearestVertex nearest(view, settings, place);
  const auto& objects = scene.geometry->objects;
  for (std::size_t object = 0; object < objects.size(); ++object) {
    const auto* instance = std::get_if<Instance>(&objects[object].shape);
    if (!instance) continue;
    const Mesh& mesh = *scene.geometry->meshes[instance->mesh];
    const auto offer = [&](std::size_t vertex) {
      nearest.offer({static_cast<int>(object), static_cast<int>(vertex)},
                    model_to_world(instance->transform, ModelOrder::turn_then_move, mesh.positions[vertex]));
    };
    if (triangle.triangle < 0) {
      for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) offer(vertex);
    } else if (static_cast<int>(object) == triangle.object &&
               static_cast<std::size_t>(triangle.triangle) < mesh.triangles.size()) {
      for (const std::uint32_t vertex : mesh.triangles[static_cast<std::size_t>(triangle.triangle)].position)
        offer(vertex);
    }
  }
  if (!nearest.best() && triangle.triangle >= 0) return nearest_vertex(scene, view, settings, place, PixelId{});
  return nearest.best();
}

std::vector<ProjectedVertex> projected_vertices(const Scene& scene, const View& view, const Settings& settings,
                                                std::size_t most) {
  const raster::CameraSpace space = raster::make_camera_space(view.camera);
  const Viewport<double> viewport = make_viewport<double>(view, settings);
  const auto projection = raster::make_canvas_projection<double>(viewport);
  std::vector<ProjectedVertex> seen;
  const auto& objects = scene.geometry->objects;
  for (std::size_t object = 0; object < objects.size(); ++object) {
    const auto* instance = std::get_if<Instance>(&objects[object].shape);
    if (!instance) continue;
    const Mesh& mesh = *scene.geometry->meshes[instance->mesh];
    for (std::size_t vertex = 0; vertex < mesh.positions.size() && seen.size() < most; ++vertex) {
      const Vec3d camera =
          space.point(model_to_world(instance->transform, ModelOrder::turn_then_move, mesh.positions[vertex]));
      if (!(camera.z >= settings.near * viewport.distance)) continue;
      const Vec2d at = projection.from_top_left(camera);
      if (at.x >= 0 && at.x < view.width && at.y >= 0 && at.y < view.height)
        seen.push_back({{static_cast<int>(object), static_cast<int>(vertex)}, at, camera.z});
    }
  }
  return seen;
}

int event_of_shown(const PixelStory& story) {
  int shown = -1, first_hit = -1;
  for (std::size_t i = 0; i < story.events.size(); ++i) {
    const EventData& data = story.events[i].data;
    const auto* fragment = std::get_if<FragmentEvent>(&data);
    if (fragment && fragment->depth != FragmentEvent::Depth::failed) shown = static_cast<int>(i);
    if (first_hit < 0 && std::holds_alternative<HitEvent>(data)) first_hit = static_cast<int>(i);
  }
  return shown >= 0 ? shown : first_hit;
}

PixelId shown_triangle(const PixelStory& story) {
  const int event = event_of_shown(story);
  if (event < 0) return {};
  const EventData& data = story.events[static_cast<std::size_t>(event)].data;
  if (const auto* fragment = std::get_if<FragmentEvent>(&data)) return fragment->id;
  return std::get<HitEvent>(data).id;
}

void add_vertex(const VertexChain& chain, const Camera& camera, SpaceModel& model) {
  const auto point = [&](const Vec3d& at, std::string label, bool emphasised) {
    SpaceItem item;
    item.kind = SpaceKind::hit_point;
    item.shape = SpaceShape::point;
    item.points = {at};
    item.emphasised = emphasised;
    item.label = std::move(label);
    model.items.push_back(std::move(item));
  };
  const auto line = [&](SpaceShape shape, const Vec3d& from, const Vec3d& to, bool emphasised) {
    SpaceItem item;
    item.kind = SpaceKind::sight_line;
    item.shape = shape;
    item.points = {from, to};
    item.emphasised = emphasised;
    model.items.push_back(std::move(item));
  };
  const std::string name = fmt::format("vertex {}", chain.id.vertex);
  point(chain.model, name + " in its model", false);
  point(chain.world, name, true);
  line(SpaceShape::arrow, chain.model, chain.world, false);
  line(SpaceShape::line, camera.position, chain.world, true);
  if (!(chain.camera.z > 0)) return;
  const Vec3d on_image = camera.position + camera.right * chain.viewport.x + camera.up * chain.viewport.y +
                         camera.forward * camera.projection_plane_d;
  point(on_image, name + " on the image", true);
}

}  // namespace ps
