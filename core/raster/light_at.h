#pragma once
#include <optional>

#include "inspect/recorder.h"
#include "raster/pass.h"
#include "shade/illumination.h"

namespace ps::raster {

/// The illumination equation at one world-space point of a surface. Nothing blocks light: the rasterizer has no shadow
/// rays.
template <class Real, class Recorder>
Lighting<Real> light_at(const Pass<Real>& pass, const Surface<Real>& surface, const Vec3<Real>& position,
                        const Vec3<Real>& normal, Recorder& recorder, std::optional<int> only_light = {}) {
  recorder.count(Counter::shading_calls);
  const LitPoint<Real> point{position, normal, pass.to_eye(position)};
  const auto nothing_blocks = [](int, const Vec3<Real>&, Real) { return std::optional<PixelId>(); };
  std::span<const ShadingLight<Real>> lights(pass.lights);
  if (only_light) lights = lights.subspan(static_cast<std::size_t>(*only_light), 1);
  return illuminate(point, surface.material, lights, illumination_options(pass.settings), nothing_blocks, recorder,
                    only_light.value_or(0));
}

}  // namespace ps::raster
