#pragma once
#include <cmath>
#include <vector>

#include "image/mip_chain.h"
#include "image/texel.h"
#include "image/texture_choices.h"

namespace ps {

/// Reading a texture (CGFS ch. 14). u and v in [0, 1] span the picture, v = 0 is its top row; the centre of texel (x,
/// y) lies at ((x + 0.5) / width, (y + 0.5) / height).
///
/// The order of operations is a contract, so that a SIMD version can repeat it to the bit. Per axis, all in Real:
///   t = wrapped(u)                          one of the three forms of wrap_coordinate()
///   nearest:   x = floor(t * size), then at most size - 1
///   bilinear:  p = t * size - 0.5, x0 = floor(p), f = p - x0, neighbours x0 and x0 + 1 wrapped by texel
///   mix:       left = tl * (1 - fy) + bl * fy, right likewise, colour = left * (1 - fx) + right * fx
///   levels:    fine * (1 - f) + coarse * f, only if f > 0
/// Every sum is of two products in this order, channel by channel; no fused operation, no reciprocal.

template <class Real>
struct TextureSample {
  Vec3<Real> colour{0, 0, 0};
  Real level = 0;  ///< level of detail that was used: clamped, and whole where the filter picks one level
  int texels = 0;  ///< texels read
};

/// How to read. `level` counts only for mipmap and trilinear.
template <class Real>
struct TextureLookup {
  TextureFilter filter = TextureFilter::nearest;
  TextureWrap wrap = TextureWrap::repeat;
  Real level = 0;  ///< level of detail, already with its bias (image/mip_level.h)
};

/// Where the texels of one lookup are noted for the inspector; nullptr in pictures.
using TexelNotes = std::vector<Texel>*;

/// std::floor, to the same value, without a call for numbers that fit an int.
template <class Real>
inline Real floor_of(Real value) {
  constexpr Real fits = Real(1 << 30);
  if (!(value > -fits && value < fits)) return std::floor(value);
  const Real cut = static_cast<Real>(static_cast<int>(value));
  return cut > value ? cut - Real(1) : cut;
}

/// A texture coordinate brought into [0, 1]. NaN and infinities give 0 or 1.
template <class Real>
inline Real wrap_coordinate(Real u, TextureWrap wrap) {
  Real t = u;
  switch (wrap) {
  case TextureWrap::repeat:
    t = u - floor_of(u);
    break;
  case TextureWrap::clamp:
    break;
  case TextureWrap::mirror: {
    const Real half = u * Real(0.5);
    t = (half - floor_of(half)) * Real(2);
    if (t > 1) t = Real(2) - t;
    break;
  }
  }
  if (!(t > 0)) return 0;
  return t < 1 ? t : Real(1);
}

/// A texel index in [-1, size] brought into [0, size): around for repeat, to the border for clamp and mirror (where the
/// texel beyond the border equals the border's).
inline int wrap_texel(int x, int size, TextureWrap wrap) {
  if (x < 0) return wrap == TextureWrap::repeat ? size - 1 : 0;
  if (x >= size) return wrap == TextureWrap::repeat ? 0 : size - 1;
  return x;
}

template <class Real>
inline Vec3<Real> mix_texels(const Vec3<Real>& a, const Vec3<Real>& b, Real f) {
  const Real g = Real(1) - f;
  return {a.x * g + b.x * f, a.y * g + b.y * f, a.z * g + b.z * f};
}

template <class Real>
inline Vec3<Real> read_texel(const Image<Vec3f>& image, int x, int y) {
  return Vec3<Real>(image.row(y)[static_cast<std::size_t>(x)]);
}

/// The texel that holds the point.
template <class Real>
Vec3<Real> sample_nearest(const Image<Vec3f>& image, const Vec2<Real>& uv, TextureWrap wrap, int level = 0,
                          TexelNotes notes = nullptr) {
  const auto texel = [wrap](Real u, int size) {
    const int x = static_cast<int>(wrap_coordinate(u, wrap) * static_cast<Real>(size));  // not negative: cut = floor
    return x < size ? x : size - 1;
  };
  const int x = texel(uv.x, image.width());
  const int y = texel(uv.y, image.height());
  const Vec3<Real> colour = read_texel<Real>(image, x, y);
  if (notes) notes->push_back({x, y, level, 1.0, Vec3d(colour)});
  return colour;
}

/// One axis of a bilinear lookup: two neighbouring texels and the weight of the second.
template <class Real>
struct TexelPair {
  int first = 0, second = 0;
  Real f = 0;
};

template <class Real>
inline TexelPair<Real> texel_pair(Real u, int size, TextureWrap wrap) {
  const Real p = wrap_coordinate(u, wrap) * static_cast<Real>(size) - Real(0.5);
  const Real whole = floor_of(p);
  const int x = static_cast<int>(whole);
  return {wrap_texel(x, size, wrap), wrap_texel(x + 1, size, wrap), p - whole};
}

/// The four texels around the point. `share` scales only the weights that are noted.
template <class Real>
Vec3<Real> sample_bilinear(const Image<Vec3f>& image, const Vec2<Real>& uv, TextureWrap wrap, int level = 0,
                           TexelNotes notes = nullptr, Real share = 1) {
  const TexelPair<Real> x = texel_pair(uv.x, image.width(), wrap);
  const TexelPair<Real> y = texel_pair(uv.y, image.height(), wrap);
  const Vec3<Real> tl = read_texel<Real>(image, x.first, y.first);
  const Vec3<Real> tr = read_texel<Real>(image, x.second, y.first);
  const Vec3<Real> bl = read_texel<Real>(image, x.first, y.second);
  const Vec3<Real> br = read_texel<Real>(image, x.second, y.second);
  if (notes) {
    const double fx = x.f, fy = y.f, s = share;
    notes->push_back({x.first, y.first, level, s * (1 - fx) * (1 - fy), Vec3d(tl)});
    notes->push_back({x.second, y.first, level, s * fx * (1 - fy), Vec3d(tr)});
    notes->push_back({x.first, y.second, level, s * (1 - fx) * fy, Vec3d(bl)});
    notes->push_back({x.second, y.second, level, s * fx * fy, Vec3d(br)});
  }
  return mix_texels(mix_texels(tl, bl, y.f), mix_texels(tr, br, y.f), x.f);
}

/// A level of detail cut to [0, coarsest]; NaN gives 0.
template <class Real>
inline Real clamp_level(Real level, const MipChain& chain) {
  const Real coarsest = static_cast<Real>(chain.levels() - 1);
  if (!(level > 0)) return 0;
  return level < coarsest ? level : coarsest;
}

/// Bilinear in the two levels around `level`, mixed by its fraction; one level suffices where the fraction is 0.
template <class Real>
TextureSample<Real> sample_trilinear(const MipChain& chain, const Vec2<Real>& uv, TextureWrap wrap, Real level,
                                     TexelNotes notes = nullptr) {
  const Real clamped = clamp_level(level, chain);
  const int fine = static_cast<int>(clamped);
  const Real f = clamped - static_cast<Real>(fine);
  const Vec3<Real> near = sample_bilinear(chain.level(fine), uv, wrap, fine, notes, Real(1) - f);
  if (!(f > 0)) return {near, clamped, 4};
  const Vec3<Real> far = sample_bilinear(chain.level(fine + 1), uv, wrap, fine + 1, notes, f);
  return {mix_texels(near, far, f), clamped, 8};
}

/// Reads the texture as the lookup says. Mipmap takes the level nearest to `level`, halves up.
template <class Real>
TextureSample<Real> sample_texture(const MipChain& chain, const Vec2<Real>& uv, const TextureLookup<Real>& lookup,
                                   TexelNotes notes = nullptr) {
  switch (lookup.filter) {
  case TextureFilter::nearest:
    return {sample_nearest(*chain.base, uv, lookup.wrap, 0, notes), Real(0), 1};
  case TextureFilter::bilinear:
    return {sample_bilinear(*chain.base, uv, lookup.wrap, 0, notes), Real(0), 4};
  case TextureFilter::mipmap: {
    const int level = static_cast<int>(clamp_level(lookup.level, chain) + Real(0.5));
    return {sample_bilinear(chain.level(level), uv, lookup.wrap, level, notes), static_cast<Real>(level), 4};
  }
  case TextureFilter::trilinear:
    return sample_trilinear(chain, uv, lookup.wrap, lookup.level, notes);
  }
  return {};
}

}  // namespace ps
