#pragma once
#include <cmath>

#include "image/mip_level.h"
#include "image/texture_sampling.h"

namespace ps {

/// A pixel's footprint on a texture as a row of round ones: several lookups along its longer side at the level that
/// suits its shorter one, where a single lookup would have to be as blurred as the longer side is long.
template <class Real>
struct AnisotropicFootprint {
  int taps = 1;
  Real level = 0;           ///< of each tap, with its bias
  Vec2<Real> length{0, 0};  ///< the longer side, in units of u and v
};

/// At most `most` taps; with one it is the footprint that mip_level() takes. `size` is that of the finest level.
template <class Real>
AnisotropicFootprint<Real> anisotropic_footprint(const TextureDerivatives<Real>& derivatives, const Vec2<Real>& size,
                                                 int most, Real bias) {
  const auto square = [](const Vec2<Real>& v) { return v.x * v.x + v.y * v.y; };
  const bool across = square(derivatives.dx) > square(derivatives.dy);
  const Vec2<Real> longer = across ? derivatives.dx : derivatives.dy;
  const Vec2<Real> shorter = across ? derivatives.dy : derivatives.dx;
  const Real ratio = std::sqrt(square(longer) / square(shorter));  // infinite or NaN where the texture stands still
  AnisotropicFootprint<Real> footprint;
  footprint.taps = ratio < static_cast<Real>(most) ? static_cast<int>(std::ceil(ratio)) : ratio > 0 ? most : 1;
  if (footprint.taps < 1) footprint.taps = 1;
  const Real share = static_cast<Real>(footprint.taps);
  footprint.level = Real(0.5) * level_log2(square(longer) / (share * share)) + bias;
  footprint.length = {longer.x / size.x, longer.y / size.y};
  return footprint;
}

/// The mean of the taps, spread evenly along the footprint's longer side.
template <class Real>
TextureSample<Real> sample_anisotropic(const MipChain& chain, const Vec2<Real>& uv, TextureLookup<Real> lookup,
                                       const AnisotropicFootprint<Real>& footprint, TexelNotes notes = nullptr) {
  lookup.level = footprint.level;
  TextureSample<Real> sum;
  for (int i = 0; i < footprint.taps; ++i) {
    const Real place = (static_cast<Real>(i) + Real(0.5)) / static_cast<Real>(footprint.taps) - Real(0.5);
    const std::size_t noted = notes ? notes->size() : 0;
    const Vec2<Real> at(uv.x + footprint.length.x * place, uv.y + footprint.length.y * place);
    const TextureSample<Real> tap = sample_texture(chain, at, lookup, notes);
    sum.colour += tap.colour;
    sum.level = tap.level;
    sum.texels += tap.texels;
    if (notes)
      for (std::size_t k = noted; k < notes->size(); ++k) (*notes)[k].weight /= footprint.taps;
  }
  sum.colour /= static_cast<Real>(footprint.taps);
  return sum;
}

}  // namespace ps
