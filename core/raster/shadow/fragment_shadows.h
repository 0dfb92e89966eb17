#pragma once
#include "raster/base/raster_inputs.h"
#include "raster/shadow/shadow_lookup.h"
#include "raster/shadow/stencil.h"
#include "shade/illumination.h"

namespace ps::raster {

/// Answers for one fragment how much of each light it sees, from the light's shadow map or stencil buffer.
template <class Real, class Recorder>
class FragmentShadows {
 public:
  FragmentShadows(const RasterInputs<Real>& inputs, int column, int row, const Vec3<Real>& position,
                  const Vec3<Real>& normal, Real surface_error, Recorder& recorder)
      : inputs_(inputs), column_(column), row_(row), position_(position), normal_(normal),
        surface_error_(surface_error), recorder_(recorder) {}

  /// As illuminate() asks.
  Blocking<Real> operator()(int light, const Vec3<Real>&, Real) {
    const Real visible = share(light);
    if (is_shadowed(visible) && light < 32) mask_ |= 1u << light;
    return Blocking<Real>::partly(visible);
  }
  /// Bit i set: at most half of light i was seen. Knows the lights that were asked for.
  std::uint32_t mask() const { return mask_; }

 private:
  Real share(int light) {
    if (inputs_.shadow_maps)
      return share_by_map(*inputs_.shadow_maps, light, position_, normal_, inputs_.settings, surface_error_, recorder_);
    const Stencil& stencil = *inputs_.stencil;
    if constexpr (Recorder::records)
      for (const StencilEvent& event : stencil.events)
        if (event.light == light) recorder_.event([&] { return event; });
    return stencil.at(light, column_, row_) == 0 ? Real(1) : Real(0);
  }

  const RasterInputs<Real>& inputs_;
  int column_, row_;
  Vec3<Real> position_, normal_;
  Real surface_error_;
  Recorder& recorder_;
  std::uint32_t mask_ = 0;
};

}  // namespace ps::raster
