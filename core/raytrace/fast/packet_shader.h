#pragma once
#include <array>
#include <span>
#include <vector>

#include "raytrace/clear/tracer.h"
#include "raytrace/fast/shade_hits.h"
#include "record/recorder.h"

namespace ps {

/// Colours of eye rays whose hits are known: by eight where HitTables covers the surface, through the tracer elsewhere.
class PacketShader {
 public:
  using ClearTracer = Tracer<float, CountingRecorder>;

  PacketShader(const TraceInputs<float>& inputs, const HitTables& tables, const ClearTracer& tracer,
               CountingRecorder& recorder)
      : inputs_(inputs), tables_(tables), tracer_(tracer), recorder_(recorder), blocked_(inputs.lights.size()) {
    packet_.attributes.fill(-1);
    if (!shares_meshes(*inputs.geometry)) return;
    packet_.own_triangles = &own_triangles_[0].a.x;
    packet_.own_attributes = &own_attributes_[0].normals[0].x;
  }

  /// Shades the hits of up to shaded_together rays.
  void shade(std::span<const Ray<float>> rays, std::span<const Hit<float>> hits, std::span<Vec3f> colours);

 private:
  /// Puts the hit into a lane if it can be shaded there.
  bool put_lane(std::size_t lane, const Ray<float>& ray, const Hit<float>& hit);
  /// Which lights do not reach these lanes? Fills their points and normals on the way.
  void find_shadows(unsigned lanes, std::span<const Ray<float>> rays, std::span<const Hit<float>> hits);
  /// As find_shadows(), for one lane.
  void find_shadows_of(std::size_t lane, const Ray<float>& ray, const SurfacePoint<float>& surface);

  const TraceInputs<float>& inputs_;
  const HitTables& tables_;
  const ClearTracer& tracer_;
  CountingRecorder& recorder_;
  HitPacket packet_;
  std::array<TracedTriangle<float>, shaded_together> own_triangles_;  ///< of the lanes, where meshes are shared
  std::array<TriangleAttributes<float>, shaded_together> own_attributes_;
  std::vector<unsigned> blocked_;  ///< by light, a bit for each lane
};

}  // namespace ps
