#pragma once
#include "base/check.h"
#include "raster/assembly/bins.h"
#include "raster/base/fragment.h"

namespace ps::raster {

/// Is depth found where the ray through the sample meets the triangle's plane, and not interpolated?
inline bool finds_depth_by_plane(const Settings& settings) {
  return settings.visibility == Visibility::depth_buffer && settings.depth_value == DepthValue::ray_plane;
}

template <class Real>
inline TriangleSetup<Real> set_up_triangle(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry,
                                           const PrimitiveRef& ref) {
  const Batch<Real>& batch = geometry.batches[ref.batch];
  const ScreenTriangle<Real>& triangle = batch.triangles[ref.index];
  const auto edges = make_edges(triangle.corners, inputs.grid);
  PS_ASSERT(edges.has_value(), "triangles without area are left out by the assembly");
  TriangleSetup<Real> setup;
  setup.triangle = &triangle;
  setup.surface = &inputs.surfaces[triangle.surface];
  setup.attributes = batch.attributes.data() + triangle.attributes;
  setup.edges = *edges;
  setup.inverse_area = Real(1) / static_cast<Real>(edges->area);
  if (finds_depth_by_plane(inputs.settings))
    setup.plane = make_depth_plane(camera_corners(inputs, geometry, triangle), triangle.z);
  return setup;
}

/// What the channel of ids shows of a triangle.
template <class Real>
inline PixelId shown_id(const TriangleSetup<Real>& setup) {
  return {setup.surface->object, setup.surface->sphere ? 0 : setup.triangle->triangle};
}

}  // namespace ps::raster
