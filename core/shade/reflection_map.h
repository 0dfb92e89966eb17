#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "image/texture_sampling.h"
#include "math/unit.h"
#include "record/events.h"
#include "record/recorder.h"
#include "scene/material.h"
#include "scene/uv_maps.h"

namespace ps {

/// Where a picture of width x height texels shows what lies in a direction (MTL: refl -type sphere and cube_...). A map
/// of the world is as around a sphere (world_map_uv), seen from its inside; a cube is the cross of cube_cross_uv, whose
/// front is -z. Half a texel is kept from borders beyond which something else begins.
template <class Real>
inline Vec2<Real> reflection_uv(Surroundings surroundings, const Vec3<Real>& direction, int width, int height) {
  const Vec2<Real> half_texel{Real(0.5) / static_cast<Real>(width), Real(0.5) / static_cast<Real>(height)};
  switch (surroundings) {
  case Surroundings::sphere: {
    const Vec2<Real> uv = world_map_uv(unit_of(direction));
    return {uv.x, std::clamp(uv.y, half_texel.y, 1 - half_texel.y)};
  }
  case Surroundings::cube: {
    int axis = 0;
    for (int i = 1; i < 3; ++i)
      if (std::abs(direction[i]) > std::abs(direction[axis])) axis = i;
    const int face = 2 * axis + (direction[axis] > 0 ? 1 : 0);
    const Vec3<Real> on_face = direction / std::abs(direction[axis]);
    Vec3<Real> middle_point(0);
    middle_point[axis] = on_face[axis];
    const Vec2<Real> uv = cube_cross_uv(face, on_face), middle = cube_cross_uv(face, middle_point);
    const Vec2<Real> reach{std::max(Real(1) / 8 - half_texel.x, Real(0)),
                           std::max(Real(1) / 6 - half_texel.y, Real(0))};
    return {std::clamp(uv.x, middle.x - reach.x, middle.x + reach.x),
            std::clamp(uv.y, middle.y - reach.y, middle.y + reach.y)};
  }
  }
  return {};
}

/// The colour of the picture in the direction, the same for both renderers: bilinear at its finest level, or the
/// nearest texel where the option asks for that. Reports a TextureEvent.
template <class Real, class Recorder>
Vec3<Real> read_reflection_map(const Image<Vec3f>& image, int texture, Surroundings surroundings,
                               const Vec3<Real>& direction, TextureFilter filter, Recorder& recorder) {
  const Vec2<Real> uv = reflection_uv(surroundings, direction, image.width(), image.height());
  const bool nearest = filter == TextureFilter::nearest;
  std::vector<Texel> texels;
  const TexelNotes notes = Recorder::records ? &texels : nullptr;
  constexpr TextureWrap around = TextureWrap::repeat;
  const Vec3<Real> texel =
      nearest ? sample_nearest(image, uv, around, 0, notes) : sample_bilinear(image, uv, around, 0, notes);
  recorder.count(Counter::texel_reads, nearest ? 1 : 4);
  recorder.event(
      [&] { return TextureEvent{texture, Vec2d(uv), 0, std::move(texels), Vec3d(texel), TextureUse::reflection}; });
  return texel;
}

}  // namespace ps
