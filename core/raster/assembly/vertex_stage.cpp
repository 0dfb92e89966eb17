#include "raster/assembly/vertex_stage.h"

#include <cmath>

#include "raster/assembly/near_pixel.h"
#include "raster/assembly/vertex_jobs.h"

namespace ps::raster {
namespace {

template <class Real>
bool needs_vertex_normals(const RasterInputs<Real>& inputs, const Surface<Real>& surface) {
  if (inputs.settings.normals != Normals::vertex) return false;
  const bool corner_light = surface.layout.lit && inputs.settings.shading != Shading::phong;
  return surface.layout.normal != AttributeLayout::absent || surface.layout.shading_normal || corner_light;
}

template <class Real>
bool needs_world_positions(const RasterInputs<Real>& inputs, const Surface<Real>& surface) {
  const bool corner_light = surface.layout.lit && inputs.settings.shading != Shading::phong;
  return surface.layout.position != AttributeLayout::absent || surface.layout.tangents != AttributeLayout::absent ||
         corner_light;
}

/// Where a vertex lies before the camera. Camera-relative: rounded to Real last, when the camera's position is gone.
/// Otherwise world positions are rounded first, as programs do that keep them in Real: far from the origin neighbouring
/// numbers lie far apart, and vertices jump between them.
template <class Real>
Vec3<Real> camera_position(const RasterInputs<Real>& inputs, const Vec3d& world) {
  if (inputs.settings.camera_relative) return Vec3<Real>(inputs.camera_space.point(world));
  const Vec3<Real> from_eye = Vec3<Real>(world) - Vec3<Real>(inputs.camera_space.position);
  return Vec3<Real>(inputs.camera_space.from_world * Vec3d(from_eye));
}

/// Where a vertex that nothing cuts lies on the canvas. Without a place are those beyond the guard band, those too near
/// the eye's plane, and those that have no finite depth there.
template <class Real>
VertexPlace place_of(const RasterInputs<Real>& inputs, const Vec3<Real>& camera) {
  VertexPlace place;
  const Vec2<Real> at = inputs.projection.from_top_left(camera);
  constexpr Real reach = static_cast<Real>(guard_band);
  const bool placed = std::abs(at.x) <= reach && std::abs(at.y) <= reach && std::isfinite(camera.z);
  if (!placed || (inputs.perspective() && camera.z < least_depth(inputs))) {
    place.outside = VertexPlace::no_place;
    return place;
  }
  const FixedPoint fixed = to_fixed(at, inputs.grid.subpixel_bits);
  place.column = fixed.x;
  place.row = fixed.y;
  for (std::size_t i = 0; i < inputs.planes.size(); ++i)
    if (!(inputs.planes[i].distance(camera) >= 0)) place.outside |= 1u << i;
  return place;
}

}  // namespace

template <class Real>
VertexNeeds vertex_needs(const RasterInputs<Real>& inputs, std::size_t object) {
  VertexNeeds needs;
  for (std::size_t k = 0; k < inputs.objects[object].materials.size(); ++k) {
    const Surface<Real>& surface = inputs.surfaces[inputs.first_surface[object] + k];
    needs.world = needs.world || needs_world_positions(inputs, surface);
    needs.normals = needs.normals || needs_vertex_normals(inputs, surface);
  }
  return needs;
}

template <class Real>
std::vector<bool> cull_objects(const RasterInputs<Real>& inputs) {
  std::vector<bool> culled;
  for (const DrawObject& object : inputs.objects) {
    const Vec3<Real> centre(inputs.camera_space.point(object.bounds.centre));
    const auto radius = static_cast<Real>(object.bounds.radius);
    culled.push_back(std::any_of(inputs.planes.begin(), inputs.planes.end(),
                                 [&](const ClipPlane<Real>& plane) { return plane.distance(centre) < -radius; }));
  }
  return culled;
}

template <class Real>
std::vector<VertexBuffer<Real>> run_vertex_stage(const RasterInputs<Real>& inputs, const std::vector<bool>& culled,
                                                 VertexUse use, const ParallelOptions& parallel, Progress& progress) {
  const bool one_pixel = use == VertexUse::pixel;
  std::vector<VertexBuffer<Real>> buffers(inputs.objects.size());
  std::vector<VertexJob> jobs;
  for (std::size_t i = 0; i < inputs.objects.size(); ++i) {
    if (culled[i]) continue;
    const Mesh& mesh = *inputs.objects[i].mesh;
    const VertexNeeds needs = vertex_needs(inputs, i);
    buffers[i].camera.resize(mesh.positions.size());
    add_vertex_jobs(jobs, i, mesh.positions.size(), false);
    if (one_pixel) {
      buffers[i].places.resize(mesh.positions.size());
      if (needs.world) buffers[i].world_of = &inputs.objects[i];
      if (needs.normals) buffers[i].normals_of = &inputs.objects[i];
      continue;
    }
    if (needs.world) buffers[i].world.resize(mesh.positions.size());
    if (needs.normals) {
      buffers[i].normals.resize(mesh.normals.size());
      add_vertex_jobs(jobs, i, mesh.normals.size(), true);
    }
  }
  parallel_for(static_cast<int>(jobs.size()), parallel, progress, [&](int index, int) {
    const VertexJob& job = jobs[static_cast<std::size_t>(index)];
    const DrawObject& object = inputs.objects[job.object];
    VertexBuffer<Real>& buffer = buffers[job.object];
    for (std::size_t v = job.first; v < job.last; ++v) {
      if (job.normals) {
        buffer.normals[v] = Vec4<Real>(Vec3<Real>(object.world_normal(v)), 0);
      } else {
        const Vec3d world = object.world(object.mesh->positions[v]);
        const Vec3<Real> camera = camera_position(inputs, world);
        buffer.camera[v] = Vec4<Real>(camera, 0);
        if (one_pixel) buffer.places[v] = place_of(inputs, camera);
        if (!buffer.world.empty()) buffer.world[v] = Vec4<Real>(Vec3<Real>(world), 0);
      }
    }
  });
  return buffers;
}

// NOLINTBEGIN(bugprone-macro-parentheses): Real is a type
#define PS_INSTANTIATE(Real)                                                                                           \
  template VertexNeeds vertex_needs(const RasterInputs<Real>&, std::size_t);                                           \
  template std::vector<bool> cull_objects(const RasterInputs<Real>&);                                                  \
  template std::vector<VertexBuffer<Real>> run_vertex_stage(const RasterInputs<Real>&, const std::vector<bool>&,       \
                                                            VertexUse, const ParallelOptions&, Progress&);
PS_INSTANTIATE(float)
PS_INSTANTIATE(double)
#undef PS_INSTANTIATE
// NOLINTEND(bugprone-macro-parentheses)

}  // namespace ps::raster
