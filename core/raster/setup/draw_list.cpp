#include "raster/setup/draw_list.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "base/stop.h"
#include "frame/memory_need.h"
#include "raster/setup/place_mesh.h"
#include "raster/setup/tessellate.h"
#include "raster/setup/tessellate_patches.h"
#include "raster/setup/tessellate_solid.h"
#include "scene/generate/bezier_patch.h"
#include "scene/world.h"

namespace ps::raster {
namespace {

/// One mesh for each object; empty pointers for instances that keep their model's.
struct Meshes {
  std::vector<std::shared_ptr<const Mesh>> of_object;
  std::vector<std::shared_ptr<const MeshCorners>> corners;

  void add(std::shared_ptr<const Mesh> mesh) {
    corners.push_back(mesh ? std::make_shared<const MeshCorners>(make_mesh_corners(*mesh)) : nullptr);
    of_object.push_back(std::move(mesh));
  }
  std::size_t heap_bytes() const {
    std::size_t bytes = of_object.capacity() * sizeof(of_object[0]) + owned_bytes(corners);
    for (const auto& mesh : of_object)
      if (mesh) bytes += sizeof(Mesh) + owned_bytes(mesh->positions, mesh->normals, mesh->uvs, mesh->triangles);
    return bytes;
  }
};
/// What the draw list holds of the scene's own models.
struct Models {
  std::vector<BoundingSphere> bounds;
  std::vector<std::shared_ptr<const MeshCorners>> corners;

  std::size_t heap_bytes() const { return owned_bytes(bounds, corners); }
};

Key& add(Key& key, const Vec3d& v) { return key.add(v.x).add(v.y).add(v.z); }

/// The model of an instance that is curved, where the settings ask for its triangles anew; else null.
const Mesh* curved_model(const Scene& scene, const Object& object, Patches patches) {
  const auto* instance = std::get_if<Instance>(&object.shape);
  if (!instance || patches != Patches::projected_error) return nullptr;
  const Mesh& model = *scene.geometry->meshes.at(instance->mesh);
  return model.patches.empty() ? nullptr : &model;
}

int divisions_of(const Mesh& model, const Object& object, const TessellationView& view) {
  const Transform& transform = std::get<Instance>(object.shape).transform;
  std::vector<BezierPatch> world = model.patches;
  const Mat3d linear = linear_part(transform);
  for (BezierPatch& patch : world)
    for (Vec3d& p : patch.control) p = linear * p + transform.translation;
  return patch_divisions(world, view);
}

/// The view by which a solid is cut into triangles, in its own space.
TessellationView seen_from_solid(const Solid& solid, const TessellationView& view) {
  return solid.place.is_identity() ? view : seen_from_within(solid.place, view);
}

/// How fine each curved model is cut, and the triangles of all objects together.
struct TriangleCount {
  std::vector<int> divisions;  ///< by object; 0 = not a curved model
  std::uint64_t triangles = 0;
};

TriangleCount count_triangles(const Scene& scene, const Settings& settings, const TessellationView& view) {
  TriangleCount count;
  for (const Object& object : scene.geometry->objects) {
    check_stop();
    const Mesh* model = curved_model(scene, object, settings.patches);
    count.divisions.push_back(model ? divisions_of(*model, object, view) : 0);
    const auto divisions = static_cast<std::uint64_t>(count.divisions.back());
    if (model) count.triangles += model->patches.size() * 2 * divisions * divisions;
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) count.triangles += sphere_triangles(*sphere, view);
    if (const auto* solid = std::get_if<Solid>(&object.shape))
      count.triangles += solid_triangles(*solid, seen_from_solid(*solid, view));
  }
  return count;
}

/// With a share of the vertices, and what a pass makes of each before it is drawn.
constexpr std::uint64_t bytes_of_triangle = 144;

/// A box, plane or the like in the world.
Mesh mesh_of_solid(const Scene& scene, const Solid& solid, const TessellationView& view) {
  Mesh mesh = tessellate_solid(solid, seen_from_solid(solid, view));
  if (solid.place.is_identity()) return mesh;
  const auto* ball = std::get_if<Ball>(&solid.form);
  if (ball && needs_uv(scene.materials->at(solid.material))) add_world_map_uvs(mesh, ball->centre);
  place_mesh(solid.place, mesh);
  return mesh;
}

FarSide far_side(const Settings& settings) {
  switch (settings.shadows) {
  case Shadows::stencil_depth_fail:
  case Shadows::stencil_depth_pass:
    return FarSide::seen;
  case Shadows::traced:
  case Shadows::map:
  case Shadows::none:
    break;
  }
  return settings.backface_culling ? FarSide::hidden : FarSide::seen;
}

std::shared_ptr<const Meshes> tessellations(const Scene& scene, const View& view, const Settings& settings,
                                            const Viewport<double>& viewport, Prepared& prepared) {
  Key key("sphere-tessellation");
  key.add(scene.geometry.revision())
      .add(scene.materials.revision())
      .add(settings.tessellation)
      .add(settings.patches)
      .add(settings.near)
      .add(settings.projection)
      .add(far_side(settings));
  add(add(key, view.camera.position), view.camera.forward);
  key.add(viewport.width).add(viewport.height).add(viewport.span_x).add(viewport.span_y).add(viewport.distance);
  key.add(static_cast<std::uint64_t>(view.width)).add(static_cast<std::uint64_t>(view.height));
  return prepared.get<Meshes>(key, [&] {
    TessellationView seen_from = make_tessellation_view(view.camera, viewport, settings.near, settings.tessellation);
    seen_from.far_side = far_side(settings);
    const TriangleCount count = count_triangles(scene, settings, seen_from);
    require({count.triangles * bytes_of_triangle,
             fmt::format("the {} triangles of spheres and curved models", count.triangles),
             "set a larger 'tessellation', or draw a smaller picture"},
            prepared);
    Meshes meshes;
    const auto& objects = scene.geometry->objects;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const Object& object = objects[i];
      check_stop();
      const auto* sphere = std::get_if<Sphere>(&object.shape);
      const auto* solid = std::get_if<Solid>(&object.shape);
      if (sphere) {
        Mesh mesh = tessellate_sphere(*sphere, seen_from);
        const Material& material = scene.materials->at(sphere->material);
        if (needs_uv(material)) add_world_map_uvs(mesh, sphere->centre);
        meshes.add(std::make_shared<const Mesh>(std::move(mesh)));
      } else if (solid) {
        meshes.add(std::make_shared<const Mesh>(mesh_of_solid(scene, *solid, seen_from)));
      } else if (const Mesh* model = curved_model(scene, object, settings.patches)) {
        Mesh mesh = tessellate(model->patches, count.divisions[i]);
        mesh.materials = model->materials;
        meshes.add(std::make_shared<const Mesh>(std::move(mesh)));
      } else {
        meshes.add(nullptr);
      }
    }
    return meshes;
  });
}

std::shared_ptr<const Models> known_models(const Scene& scene, Prepared& prepared) {
  return prepared.get<Models>(Key("models").add(scene.geometry.revision()), [&] {
    Models models;
    for (const auto& mesh : scene.geometry->meshes) {
      check_stop();
      models.bounds.push_back(bounding_sphere(*mesh));
      models.corners.push_back(std::make_shared<const MeshCorners>(make_mesh_corners(*mesh)));
    }
    return models;
  });
}

Mat3d normal_matrix(const Mat3d& linear, bool mirrored, NormalTransform how) {
  switch (how) {
  case NormalTransform::inverse_transpose:
    // The matrix of cofactors is the inverse transpose times the determinant: it needs no division, so a model that is
    // scaled flat in one direction keeps its normals, and its sign follows a mirrored model.
    return Mat3d(cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1])) *
           (mirrored ? -1.0 : 1.0);
  case NormalTransform::model:
    return linear;
  }
  return linear;
}

DrawObject place_instance(const Scene& scene, int index, const Instance& instance, const Models& models,
                          NormalTransform how) {
  const Transform& transform = instance.transform;
  DrawObject draw;
  draw.object = index;
  draw.mesh = scene.geometry->meshes.at(instance.mesh);
  draw.corners = models.corners.at(instance.mesh);
  draw.linear = linear_part(transform);
  draw.mirrored = mirrors(transform);
  draw.normal_matrix = normal_matrix(draw.linear, draw.mirrored, how);
  draw.translation = transform.translation;
  draw.front_only = instance.sides == Sides::front;
  const BoundingSphere& model = models.bounds.at(instance.mesh);
  draw.bounds = {draw.world(model.centre), model.radius * largest_stretch(draw.linear)};
  draw.materials = instance.material ? std::vector<std::uint32_t>{*instance.material} : draw.mesh->materials;
  return draw;
}

}  // namespace

std::vector<DrawObject> make_draw_list(const Scene& scene, const View& view, const Settings& settings,
                                       const Viewport<double>& viewport, Prepared& prepared) {
  const auto& objects = scene.geometry->objects;
  const bool any_sphere = std::any_of(objects.begin(), objects.end(), [&](const Object& o) {
    return std::holds_alternative<Sphere>(o.shape) || std::holds_alternative<Solid>(o.shape) ||
           curved_model(scene, o, settings.patches) != nullptr;
  });
  const auto spheres = any_sphere ? tessellations(scene, view, settings, viewport, prepared) : nullptr;
  const auto models = known_models(scene, prepared);
  std::vector<DrawObject> list;
  list.reserve(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const int index = static_cast<int>(i);
    if (const auto* sphere = std::get_if<Sphere>(&objects[i].shape)) {
      DrawObject draw;
      draw.object = index;
      draw.mesh = spheres->of_object[i];
      draw.corners = spheres->corners[i];
      draw.sphere = true;
      draw.bounds = {sphere->centre, sphere->radius};
      draw.materials = {sphere->material};
      list.push_back(std::move(draw));
    } else if (const auto* solid = std::get_if<Solid>(&objects[i].shape)) {
      DrawObject draw;
      draw.object = index;
      draw.mesh = spheres->of_object[i];
      draw.corners = spheres->corners[i];
      draw.sphere = true;
      draw.front_only = solid->sides == Sides::front || is_flat(solid->form);
      draw.bounds = bounding_sphere(*draw.mesh);
      draw.materials = {solid->material};
      list.push_back(std::move(draw));
    } else if (std::holds_alternative<Instance>(objects[i].shape)) {  // CSG has no triangles: left_out() says so
      list.push_back(
          place_instance(scene, index, std::get<Instance>(objects[i].shape), *models, settings.normal_transform));
      if (spheres && spheres->of_object[i]) {
        list.back().mesh = spheres->of_object[i];
        list.back().corners = spheres->corners[i];
        list.back().sphere = true;
        const BoundingSphere model = bounding_sphere(*list.back().mesh);
        list.back().bounds = {list.back().world(model.centre), model.radius * largest_stretch(list.back().linear)};
      }
    }
  }
  return list;
}

}  // namespace ps::raster
