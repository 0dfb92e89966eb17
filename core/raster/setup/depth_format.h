#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "options/settings.h"

namespace ps::raster {

/// How the depth buffer holds the value that it compares (options `depth-value`, `depth-format`, `depth-bits`,
/// `depth-reversed`), after the depth formats of Direct3D and OpenGL.
struct DepthCode {
  DepthValue value = DepthValue::inverse_z;
  DepthFormat format = DepthFormat::plain;
  int bits = 24;          ///< of an integer
  bool reversed = false;  ///< 1 at the near plane, 0 at the far one; with the plain format unused
  double near = 1;        ///< z or distance that the range from 0 to 1 begins with
  double far = 0;         ///< where it ends; 0 = nowhere, which only 1 / z can map

  bool larger_is_nearer() const { return format == DepthFormat::plain ? value == DepthValue::inverse_z : reversed; }

  /// What is stored for 1 / z, z (however it is found) or the distance, whichever `value` names. Values outside the
  /// range are clamped to it; NaN stays NaN, which is nearer than nothing.
  template <class Real>
  Real encode(Real raw) const {
    switch (format) {
    case DepthFormat::plain:
      return raw;
    case DepthFormat::unit_float:
      return static_cast<Real>(static_cast<float>(share(static_cast<double>(raw))));
    case DepthFormat::unorm: {
      const double largest = std::ldexp(1.0, bits) - 1;
      return static_cast<Real>(std::floor(share(static_cast<double>(raw)) * largest + 0.5));
    }
    }
    return raw;
  }

 private:
  /// From 0 at the near plane to 1 at the far one, or reversed. Each direction has its own formula: 1 - x would round
  /// away what reversing gains in float.
  double share(double raw) const {
    double share = 0;
    if (value == DepthValue::inverse_z) {
      const double end = far > 0 ? near / far : 0;
      share = (reversed ? near * raw - end : 1 - near * raw) / (1 - end);
    } else {
      share = (reversed ? far - raw : raw - near) / (far - near);
    }
    return share < 0 ? 0 : share > 1 ? 1 : share;
  }
};

/// `unit` is the distance of the projection plane, in which near and far are measured. A format from 0 to 1 needs a far
/// limit unless it holds 1 / z; without one the plain format is used.
inline DepthCode make_depth_code(const Settings& settings, double unit) {
  DepthCode code;
  code.value = settings.depth_value;
  code.bits = settings.depth_bits;
  code.reversed = settings.depth_reversed;
  code.near = settings.near * unit;
  code.far = settings.far < no_far_limit ? settings.far * unit : 0;
  if (code.far > code.near || code.value == DepthValue::inverse_z) code.format = settings.depth_format;
  return code;
}

/// What the depth buffer holds where nothing was drawn: farther than everything, also than the far plane.
template <class Real>
inline Real empty_depth(const DepthCode& code) {
  return code.larger_is_nearer() ? -std::numeric_limits<Real>::infinity() : std::numeric_limits<Real>::infinity();
}

/// Whether a fragment lies before what is stored. Equal is not nearer: the first triangle drawn, which has the lowest
/// index, keeps the pixel.
template <class Real>
inline bool is_nearer(const DepthCode& code, Real depth, Real stored) {
  return code.larger_is_nearer() ? depth > stored : depth < stored;
}

}  // namespace ps::raster
