#pragma once
#include <optional>
#include <vector>

#include "raster/setup/attributes.h"
#include "raster/setup/draw_list.h"
#include "shade/normal_mapping.h"
#include "shade/shading_inputs.h"

namespace ps::raster {

/// All triangles of one object that share a material.
template <class Real>
struct Surface {
  int object = 0;         ///< index into Geometry::objects
  std::size_t drawn = 0;  ///< index into the draw list, which leaves out what has no triangles
  bool sphere = false;
  AttributeLayout layout;
  ShadingMaterial<Real> material;
  std::optional<Placing<Real>> placing;  ///< where mapped normals go by the inverse transpose
};

/// The surfaces of all objects of a picture, object by object.
template <class Real>
struct Surfaces {
  std::vector<Surface<Real>> list;
  std::vector<std::uint32_t> first;  ///< of each object of the draw list
  bool textured = false;             ///< some surface reads a texture
};

template <class Real>
Surfaces<Real> make_surfaces(const Scene& scene, const std::vector<DrawObject>& objects, const Settings& settings,
                             Channel channels);

}  // namespace ps::raster
