#pragma once
#include <algorithm>
#include <cmath>

#include "raster/base/fragment.h"
#include "raster/environment/environment_map.h"
#include "raster/shadow/cube_face.h"
#include "shade/illumination.h"

namespace ps::raster {

/// What lies in a direction, whatever point it starts from: bilinear within the face that it goes through.
template <class Real, class Recorder>
Vec3<Real> look_up_environment(const EnvironmentMap& map, const Vec3<Real>& direction, Recorder& recorder) {
  const int face = cube_face_of(direction);
  const Vec2<Real> position = face_position(in_face(cube_faces()[static_cast<std::size_t>(face)], direction), map.size);
  const Image<Vec3f>& texels = map.faces[static_cast<std::size_t>(face)];
  const Real x = position.x - Real(0.5), y = position.y - Real(0.5);
  const Real left = std::floor(x), top = std::floor(y);
  const auto texel = [&](int dx, int dy) {
    const int column = std::clamp(static_cast<int>(left) + dx, 0, map.size - 1);
    const int row = std::clamp(static_cast<int>(top) + dy, 0, map.size - 1);
    return Vec3<Real>(texels.at(column, row));
  };
  const Real u = x - left, v = y - top;
  const Vec3<Real> result =
      (texel(0, 0) * (1 - u) + texel(1, 0) * u) * (1 - v) + (texel(0, 1) * (1 - u) + texel(1, 1) * u) * v;
  recorder.count(Counter::environment_reads);
  recorder.event([&] {
    return EnvironmentEvent{map.centre, Vec3d(direction), face, Vec2d(position), Vec3d(result), map.left_out};
  });
  return result;
}

/// Environment mapping (CGFS ch. 15): the fragment's colour mixed with what its object's cube map shows in the mirrored
/// direction of view, in the shares of CGFS ch. 4. `normal` has length 1. The colour itself where nothing is mirrored.
template <class Real, class Recorder>
Vec3<Real> mirror_environment(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                              const Fragment<Real>& fragment, const Vec3<Real>& normal, const Vec3<Real>& local,
                              std::optional<int> only_light, Recorder& recorder) {
  const Real reflective = setup.surface->material.reflective;
  const auto& map = (*inputs.environment)[static_cast<std::size_t>(setup.surface->object)];
  const int slot = setup.surface->layout.position;
  if (!(reflective > 0) || !map || slot == AttributeLayout::absent) return local;
  if (only_light.value_or(0) != 0) return local * (1 - reflective);  // the rest came with the first light
  const Vec3<Real> position = interpolate3(inputs, setup, fragment, slot);
  const Vec3<Real> reflected = look_up_environment(*map, mirror(inputs.to_eye(position), normal), recorder);
  const Vec3<Real> result = local * (1 - reflective) + reflected * reflective;
  recorder.event([&] {
    return ReflectionEvent{static_cast<double>(reflective), Vec3d(local), Vec3d(reflected), Vec3d(result)};
  });
  return result;
}

}  // namespace ps::raster
