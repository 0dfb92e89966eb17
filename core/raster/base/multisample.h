#pragma once
#include <span>

#include "raster/base/edge_function.h"

namespace ps::raster {

/// Where the sub-samples lie, in sixteenths of a pixel from its centre: the rotated grids that Direct3D calls standard.
/// No two of them share a row or a column, so flat and steep edges get as many levels as there are samples.
struct SubSample {
  int x = 0, y = 0;
};

/// Where a sub-sample lies in its pixel, from 0 to 1, if the sample that the pattern surrounds lies at `centre`.
inline Vec2d place_in_pixel(const SubSample& sample, const Vec2d& centre) {
  return {centre.x + sample.x / 16.0, centre.y + sample.y / 16.0};
}

inline std::span<const SubSample> sample_pattern(int samples) {
  static constexpr std::array<SubSample, 2> two{{{4, 4}, {-4, -4}}};
  static constexpr std::array<SubSample, 4> four{{{-2, -6}, {6, -2}, {-6, 2}, {2, 6}}};
  static constexpr std::array<SubSample, 8> eight{
      {{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}}};
  if (samples >= 8) return eight;
  if (samples >= 4) return four;
  return two;
}

/// The largest power of two that is not above the setting: 1, 2, 4 or 8.
inline int sample_count(int multisampling) {
  return multisampling >= 8 ? 8 : multisampling >= 4 ? 4 : multisampling >= 2 ? 2 : 1;
}

/// Edge values at sub-samples, exactly. With fewer than three sub-pixel bits a sixteenth of a pixel is not a whole
/// number of units, so values are multiplied by a power of two, `scale`.
struct SubSampleEdges {
  std::int64_t scale = 1;
  std::array<std::int64_t, 3> along_x{}, along_y{};  ///< change for a sixteenth of a pixel
  std::array<std::int64_t, 3> threshold{};

  std::array<std::int64_t, 3> at(const std::array<std::int64_t, 3>& middle, const SubSample& sample) const {
    std::array<std::int64_t, 3> values;
    for (std::size_t i = 0; i < 3; ++i) values[i] = middle[i] * scale + along_x[i] * sample.x + along_y[i] * sample.y;
    return values;
  }
  /// Thresholds are 0 or -1, which scaling does not move.
  bool inside(const std::array<std::int64_t, 3>& value) const {
    return value[0] > threshold[0] && value[1] > threshold[1] && value[2] > threshold[2];
  }
};

inline SubSampleEdges make_sub_sample_edges(const EdgeFunctions& edges, int subpixel_bits) {
  SubSampleEdges sub;
  const std::int64_t unit = fixed_unit(subpixel_bits);
  sub.scale = std::max<std::int64_t>(1, 16 / unit);
  for (std::size_t i = 0; i < 3; ++i) {
    sub.along_x[i] = edges.step_x[i] * sub.scale / 16;
    sub.along_y[i] = edges.step_y[i] * sub.scale / 16;
    sub.threshold[i] = edges.threshold[i];
  }
  return sub;
}

}  // namespace ps::raster
