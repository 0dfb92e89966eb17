#pragma once
#include <string>

#include "raster/base/depth_test.h"
#include "raster/base/fragment.h"

namespace ps::raster {

inline Vec2d canvas_pixels(const FixedPoint& point, int subpixel_bits) {
  const auto unit = static_cast<double>(fixed_unit(subpixel_bits));
  return {static_cast<double>(point.x) / unit, static_cast<double>(point.y) / unit};
}

/// Edge values in square pixels.
inline std::array<double, 3> edges_in_pixels(const std::array<std::int64_t, 3>& values, int subpixel_bits) {
  const auto unit = static_cast<double>(fixed_unit(subpixel_bits));
  std::array<double, 3> edges;
  for (std::size_t i = 0; i < 3; ++i) edges[i] = static_cast<double>(values[i]) / (unit * unit);
  return edges;
}

/// A sphere is one primitive: its events carry triangle 0, as rays' do.
template <class Real>
PixelId event_id(const TriangleSetup<Real>& setup) {
  return {setup.surface->object, setup.surface->sphere ? 0 : setup.triangle->triangle};
}

/// The same for a triangle that drew nothing, with its index among the sphere's triangles as a detail.
inline void name_by_object(bool sphere, RejectEvent& event) {
  if (!sphere) return;
  event.detail += (event.detail.empty() ? "" : ", ") + ("its triangle " + std::to_string(event.id.triangle));
  event.id.triangle = 0;
}

/// All that is known of a covered sample before it is shaded. `stored` is the depth buffer's value before the test.
template <class Real>
FragmentEvent fragment_event(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                             const Fragment<Real>& fragment, const std::array<std::int64_t, 3>& values,
                             FragmentEvent::Depth verdict, Real stored, Real depth) {
  FragmentEvent event;
  event.id = event_id(setup);
  if (setup.surface->sphere) event.sphere_triangle = setup.triangle->triangle;
  const int bits = inputs.grid.subpixel_bits;
  const std::array<Real, 3> weights = space_weights(inputs, setup, fragment);
  event.edges = edges_in_pixels(values, bits);
  event.tie_owned = {values[0] == 0, values[1] == 0, values[2] == 0};
  for (std::size_t i = 0; i < 3; ++i) {
    event.corners[i] = canvas_pixels(setup.triangle->corners[i], bits);
    event.corner_depth[i] = static_cast<double>(setup.triangle->z[i]);
    event.weights_2d[i] = static_cast<double>(fragment.weights[i]);
    event.weights[i] = static_cast<double>(weights[i]);
  }
  event.z = static_cast<double>(fragment.z);
  event.inverse_z = static_cast<double>(fragment.inverse_z);
  event.depth = verdict;
  event.depth_stored = static_cast<double>(stored);
  event.depth_new = static_cast<double>(depth);
  event.back_face = setup.triangle->back_face;
  event.clipped_into = setup.triangle->pieces;
  return event;
}

/// The first edge that keeps a sample out: "edge 1", or that it runs through the sample and leaves it to its neighbour.
inline std::string losing_edge(const EdgeFunctions& edges, const std::array<std::int64_t, 3>& values) {
  for (std::size_t i = 0; i < 3; ++i)
    if (values[i] <= edges.threshold[i])
      return values[i] == 0 ? "on edge " + std::to_string(i) + ", which does not own its samples"
                            : "edge " + std::to_string(i);
  return {};
}

template <class Real>
RejectEvent not_covered_event(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                              const std::array<std::int64_t, 3>& values) {
  RejectEvent event;
  event.id = {setup.surface->object, setup.triangle->triangle};
  event.reason = RejectReason::not_covered;
  event.detail = losing_edge(setup.edges, values);
  event.edges = edges_in_pixels(values, inputs.grid.subpixel_bits);
  name_by_object(setup.surface->sphere, event);
  return event;
}

}  // namespace ps::raster
