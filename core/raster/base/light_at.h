#pragma once
#include <optional>

#include "raster/base/raster_inputs.h"
#include "record/recorder.h"
#include "shade/illumination.h"

namespace ps::raster {

/// Nothing blocks light: the rasterizer has no shadow rays.
struct NothingBlocks {
  template <class Real>
  std::optional<PixelId> operator()(int, const Vec3<Real>&, Real) const {
    return {};
  }
};

/// The illumination equation at one world-space point of a surface, under all lights or only one of them. `blocked` as
/// illuminate() asks it.
template <class Real, class Recorder, class Blocked = NothingBlocks>
Lighting<Real> light_at(const RasterInputs<Real>& inputs, const Surface<Real>& surface, const Vec3<Real>& position,
                        const Vec3<Real>& normal, Recorder& recorder, std::optional<int> only_light = {},
                        Blocked&& blocked = {}) {
  recorder.count(Counter::shading_calls);
  const LitPoint<Real> point{position, normal, inputs.to_eye(position)};
  std::span<const ShadingLight<Real>> lights(inputs.lights);
  if (only_light) lights = lights.subspan(static_cast<std::size_t>(*only_light), 1);
  return illuminate(point, surface.material, lights, illumination_options(inputs.settings), blocked, recorder,
                    only_light.value_or(0));
}

}  // namespace ps::raster
