#pragma once
#include <array>
#include <cmath>

#include "raster/base/depth_plane.h"
#include "raster/base/multisample.h"
#include "raster/base/raster_inputs.h"
#include "raster/base/screen_triangle.h"

namespace ps::raster {

/// What a triangle's pixels share, computed once for each tile that it touches.
template <class Real>
struct TriangleSetup {
  const ScreenTriangle<Real>* triangle = nullptr;
  const Surface<Real>* surface = nullptr;
  const Real* attributes = nullptr;  ///< of vertex 0; vertices follow each other
  EdgeFunctions edges;
  Real inverse_area = 1;
  DepthPlane<Real> plane;  ///< only where depth is found by ray and plane
};

/// A covered sample. Weights are taken from the exact edge values of this sample alone, so a fragment does not depend
/// on where its tile begins.
template <class Real>
struct Fragment {
  int column = 0, row = 0;
  std::array<Real, 3> weights{};  ///< on the screen
  Real z = 0, inverse_z = 0;      ///< camera space
};

template <class Real>
inline Real weighted(const std::array<Real, 3>& weights, const std::array<Real, 3>& values) {
  return weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2];
}

template <class Real>
inline Fragment<Real> make_fragment(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup, int column,
                                    int row, const std::array<std::int64_t, 3>& edge_values) {
  Fragment<Real> fragment;
  fragment.column = column;
  fragment.row = row;
  for (std::size_t i = 0; i < 3; ++i) fragment.weights[i] = static_cast<Real>(edge_values[i]) * setup.inverse_area;
  if (inputs.perspective()) {  // 1 / z is linear on the screen (CGFS ch. 12)
    fragment.inverse_z = weighted(fragment.weights, setup.triangle->inverse_z);
    fragment.z = Real(1) / fragment.inverse_z;
  } else {
    fragment.z = weighted(fragment.weights, setup.triangle->z);
    fragment.inverse_z = Real(1) / fragment.z;
  }
  return fragment;
}

/// The fragment at a sub-sample with these values. The scale is a power of two, so dividing by it loses nothing.
template <class Real>
inline Fragment<Real> sub_sample_fragment(const RasterInputs<Real>& inputs, TriangleSetup<Real> setup,
                                          const SubSampleEdges& sub, int column, int row,
                                          const std::array<std::int64_t, 3>& values) {
  setup.inverse_area /= static_cast<Real>(sub.scale);
  return make_fragment(inputs, setup, column, row, values);
}

/// Weights in space: of the point that is seen, in terms of the vertices.
template <class Real>
inline std::array<Real, 3> space_weights(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                                         const Fragment<Real>& fragment) {
  if (!inputs.perspective()) return fragment.weights;
  std::array<Real, 3> weights;
  for (std::size_t i = 0; i < 3; ++i) weights[i] = fragment.weights[i] * setup.triangle->inverse_z[i] * fragment.z;
  return weights;
}

/// Scalar number `slot` of the surface's layout at the fragment: the one mechanism for every attribute.
template <class Real>
inline Real interpolate(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                        const Fragment<Real>& fragment, int slot) {
  const auto stride = static_cast<std::size_t>(setup.surface->layout.count);
  const Real* a = setup.attributes + slot;
  const Real sum = fragment.weights[0] * a[0] + fragment.weights[1] * a[stride] + fragment.weights[2] * a[2 * stride];
  return inputs.divides() ? sum * fragment.z : sum;
}

template <class Real>
inline Vec3<Real> interpolate3(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                               const Fragment<Real>& fragment, int slot) {
  return {interpolate(inputs, setup, fragment, slot), interpolate(inputs, setup, fragment, slot + 1),
          interpolate(inputs, setup, fragment, slot + 2)};
}

/// The three scalars of constant number `index` (0 light, 1 extra) that flat shading stored after the vertices.
template <class Real>
inline Vec3<Real> flat_constant(const TriangleSetup<Real>& setup, int index) {
  const Real* a = setup.attributes + 3 * setup.surface->layout.count + 3 * index;
  return {a[0], a[1], a[2]};
}

/// Weights of the whole triangle's vertices, where `weights` are those of the piece that clipping made of it.
template <class Real>
inline Vec3<Real> whole_weights(const TriangleSetup<Real>& setup, const std::array<Real, 3>& weights) {
  if (!setup.triangle->cut) return {weights[0], weights[1], weights[2]};
  const AttributeLayout& layout = setup.surface->layout;
  const Real* a = setup.attributes + 3 * layout.count + (layout.flat_light ? 6 : 0);
  Vec3<Real> whole(0);
  for (int axis = 0; axis < 3; ++axis)
    whole[axis] = weights[0] * a[axis] + weights[1] * a[3 + axis] + weights[2] * a[6 + axis];
  return whole;
}

}  // namespace ps::raster
