#pragma once
#include <algorithm>
#include <vector>

#include "raster/assembly/corner_attributes.h"
#include "raster/assembly/screen_geometry.h"
#include "raster/assembly/vertex_light.h"
#include "raster/base/fragment.h"
#include "raster/base/light_at.h"
#include "raster/shadow/fragment_shadows.h"

namespace ps::raster {

/// How much of each light a fragment sees, asked once for all the points where its light is computed.
template <class Real>
struct KnownShares {
  std::vector<Real> shares;  ///< by light
  Blocking<Real> operator()(int light, const Vec3<Real>&, Real) const {
    return Blocking<Real>::partly(shares[static_cast<std::size_t>(light)]);
  }
};

/// Maximum distance of the fragment from the curved surface that its triangle approximates: that many pixels (option
/// tessellation), in world units. The map has triangles of its own, so its surface is another one.
template <class Real>
Real tessellation_error(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                        const Fragment<Real>& fragment) {
  if (!setup.surface->sphere) return 0;
  const Real pixels = static_cast<Real>(inputs.settings.tessellation);
  const Real width =
      (inputs.perspective() ? fragment.z : Real(1)) / std::min(inputs.projection.scale.x, inputs.projection.scale.y);
  return pixels * width;
}

/// Light on a fragment in a picture with shadows. Whether a light is seen is always found out at the fragment itself;
/// where the light is computed at the vertices (Gouraud) or once for the triangle (flat), what they get of a light is
/// multiplied by the share of it that the fragment sees.
template <class Real, class Recorder>
Lighting<Real> shadowed_light(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry,
                              const TriangleSetup<Real>& setup, const Fragment<Real>& fragment,
                              const Vec3<Real>& normal, std::uint32_t& mask, Recorder& recorder,
                              std::optional<int> only_light) {
  const AttributeLayout& layout = setup.surface->layout;
  const bool has_position = layout.position != AttributeLayout::absent;
  const Vec3<Real> position = has_position ? interpolate3(inputs, setup, fragment, layout.position) : Vec3<Real>(0);
  FragmentShadows<Real, Recorder> shadows(inputs, fragment.column, fragment.row, position, normal,
                                          tessellation_error(inputs, setup, fragment), recorder);
  const auto known = [&] {
    KnownShares<Real> known_shares;
    for (std::size_t i = 0; i < inputs.lights.size(); ++i)
      known_shares.shares.push_back(inputs.lights[i].kind == LightKind::ambient
                                        ? Real(1)
                                        : shadows(static_cast<int>(i), Vec3<Real>(0), 0).visible);
    mask = shadows.mask();
    return known_shares;
  };
  switch (inputs.settings.shading) {
  case Shading::phong: {
    const Lighting<Real> lighting = light_at(inputs, *setup.surface, position, normal, recorder, only_light, shadows);
    mask = shadows.mask();
    return lighting;
  }
  case Shading::gouraud: {
    const KnownShares<Real> shares = known();
    const CornerSource<Real> source = corner_source(inputs, geometry, *setup.triangle);
    Lighting<Real> lighting;
    for (std::size_t k = 0; k < 3; ++k) {
      const LightPoint<Real> point = light_point(inputs, setup, fragment, source, k);
      const Lighting<Real> corner = light_of_point(inputs, setup, point, recorder, shares);
      lighting.light += corner.light * point.weight;
      lighting.extra += corner.extra * point.weight;
    }
    return lighting;
  }
  case Shading::flat: {
    const KnownShares<Real> shares = known();
    const FlatPoint<Real> point = flat_point(corner_source(inputs, geometry, *setup.triangle), inputs.settings.normals);
    return light_of_point(inputs, setup, LightPoint<Real>{point.position, point.normal}, recorder, shares);
  }
  }
  return {};
}

}  // namespace ps::raster
