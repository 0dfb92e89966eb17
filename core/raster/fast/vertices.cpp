#include "raster/fast/vertices.h"

#include "raster/assembly/vertex_jobs.h"
#include "raster/assembly/vertex_stage.h"

namespace ps::raster {
namespace {

VertexTransform transform_of(const RasterInputs<float>& inputs, const DrawObject& object) {
  VertexTransform transform;
  transform.linear = object.linear;
  transform.translation = object.translation;
  transform.from_world = inputs.camera_space.from_world;
  transform.eye = inputs.camera_space.position;
  transform.projection = inputs.projection;
  transform.planes = inputs.planes.data();
  transform.plane_count = inputs.planes.size();
  transform.subpixels = static_cast<float>(1 << inputs.grid.subpixel_bits);
  transform.normal_matrix = object.normal_matrix;
  return transform;
}

}  // namespace

std::vector<VertexBuffer<float>> run_fast_vertices(const RasterInputs<float>& inputs, const std::vector<bool>& culled,
                                                   const ParallelOptions& parallel, Progress& progress) {
  std::vector<VertexBuffer<float>> objects(inputs.objects.size());
  std::vector<VertexJob> jobs;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (culled[i]) continue;
    const Mesh& mesh = *inputs.objects[i].mesh;
    const VertexNeeds needs = vertex_needs(inputs, i);
    objects[i].camera.resize(mesh.positions.size());
    objects[i].places.resize(mesh.positions.size());
    add_vertex_jobs(jobs, i, mesh.positions.size(), false);
    if (needs.world && needs.normals && inputs.objects[i].corners->paired_normals) {
      objects[i].lit.resize(2 * mesh.positions.size());
      objects[i].world_of = objects[i].normals_of = &inputs.objects[i];
      continue;
    }
    if (needs.world) objects[i].world.resize(mesh.positions.size());
    if (needs.normals) {
      objects[i].normals.resize(mesh.normals.size());
      add_vertex_jobs(jobs, i, mesh.normals.size(), true);
    }
  }
  const VertexKernels kernels = vertex_kernels(inputs.settings.simd);
  parallel_for(static_cast<int>(jobs.size()), parallel, progress, [&](int index, int) {
    const VertexJob& job = jobs[static_cast<std::size_t>(index)];
    const DrawObject& object = inputs.objects[job.object];
    VertexBuffer<float>& made = objects[job.object];
    const std::size_t count = job.last - job.first;
    if (job.normals) {
      kernels.normals(object.normal_matrix, &object.mesh->normals[job.first], count, &made.normals[job.first]);
      return;
    }
    kernels.positions(
        transform_of(inputs, object),
        {&object.mesh->positions[job.first], made.lit.empty() ? nullptr : &object.mesh->normals[job.first], count},
        {&made.camera[job.first], &made.places[job.first], made.world.empty() ? nullptr : &made.world[job.first],
         made.lit.empty() ? nullptr : &made.lit[2 * job.first]});
  });
  return objects;
}

}  // namespace ps::raster
