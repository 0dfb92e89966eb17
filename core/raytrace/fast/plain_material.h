#pragma once
#include <cmath>

#include "shade/shading_inputs.h"

namespace ps {

/// Do the vector forms of shading know how such a surface is lit? Its colour is the same everywhere and in all terms of
/// the equation, and its highlight has an ordinary exponent.
inline bool has_plain_light(const ShadingMaterial<float>& material) {
  const bool highlight = !material.specular || (*material.specular > 0 && std::isfinite(*material.specular));
  return highlight && material.texture < 0 && material.normal_map < 0 && !material.ambient_colour &&
         !material.specular_colour && !material.varies() && material.reflection_map < 0;
}

}  // namespace ps
