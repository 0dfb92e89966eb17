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
                        const Vec3<Real>& normal, Recorder& recorder) {
  recorder.count(Counter::shading_calls);
  const LitPoint<Real> point{position, normal, pass.to_eye(position)};
  const auto nothing_blocks = [](int, const Vec3<Real>&, Real) { return std::optional<PixelId>(); };
  return illuminate(point, surface.material, std::span<const ShadingLight<Real>>(pass.lights),
                    illumination_options(pass.settings), nothing_blocks, recorder);
}

}  // namespace ps::raster
