#pragma once
#include <optional>

#include "raster/assembly/corner_attributes.h"
#include "raster/base/fragment.h"
#include "raster/base/fragment_event.h"
#include "raster/base/light_at.h"

namespace ps::raster {

/// The point of a triangle at which the light of its fragments is computed.
template <class Real>
struct LightPoint {
  Vec3<Real> position{0, 0, 0};
  Vec3<Real> normal{0, 0, 1};
  std::optional<int> vertex{};  ///< absent: the centre of the triangle
  Real weight = 1;              ///< of its light in the fragment's
};

/// Vertex `k` of the triangle, with the weight that its light has in the fragment's (Gouraud shading).
template <class Real>
LightPoint<Real> light_point(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                             const Fragment<Real>& fragment, const CornerSource<Real>& source, std::size_t k) {
  const Vec3<Real> weights =
      whole_weights(setup, inputs.divides() ? space_weights(inputs, setup, fragment) : fragment.weights);
  const int vertex = static_cast<int>(k);
  return {source.position(k), source.normal(k, inputs.settings.normals), vertex, weights[vertex]};
}

/// light_at() such a point, with the event that holds those of its lights.
template <class Real, class Recorder, class Blocked = NothingBlocks>
Lighting<Real> light_of_point(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                              const LightPoint<Real>& point, Recorder& recorder, Blocked&& blocked = {}) {
  recorder.begin([] { return VertexLightEvent{}; });
  const Lighting<Real> lighting = light_at(inputs, *setup.surface, point.position, point.normal, recorder,
                                           std::optional<int>(), std::forward<Blocked>(blocked));
  recorder.end([&] {
    return VertexLightEvent{event_id(setup),       point.vertex,        static_cast<double>(point.weight),
                            Vec3d(point.position), Vec3d(point.normal), Vec3d(lighting.light),
                            Vec3d(lighting.extra)};
  });
  return lighting;
}

}  // namespace ps::raster
