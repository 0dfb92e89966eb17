#pragma once
#include "math/unit.h"
#include "scene/normal_transform.h"
#include "scene/object.h"

namespace ps {

/// Model to world for positions: scale, rotate, translate (CGFS ch. 10). Both renderers place vertices with it.
inline Vec3d to_world(const Transform& transform, const Vec3d& position) {
  return transform.rotation * (transform.scale * position) + transform.translation;
}

/// Its linear part.
inline Mat3d linear_part(const Transform& transform) {
  return Mat3d(transform.rotation[0] * transform.scale.x, transform.rotation[1] * transform.scale.y,
               transform.rotation[2] * transform.scale.z);
}

/// The linear part of the map that places an object's surface in the world. Spheres lie there, and the parts of CSG
/// objects have places of their own.
inline Mat3d linear_part(const Object& object) {
  if (const auto* instance = std::get_if<Instance>(&object.shape)) return linear_part(instance->transform);
  if (const auto* solid = std::get_if<Solid>(&object.shape)) return solid->place.linear;
  return Mat3d(1.0);
}

/// Does the transform turn left into right (its determinant is negative)? Then vertices that ran anticlockwise around a
/// triangle's front run clockwise.
inline bool mirrors(const Transform& transform) {
  const Vec3d& s = transform.scale;
  const Mat3d& r = transform.rotation;
  const bool scale = (s.x < 0) != ((s.y < 0) != (s.z < 0));
  return scale != (dot(r[0], cross(r[1], r[2])) < 0);
}

/// The matrix that takes vertex normals to the world; their lengths are then arbitrary. The inverse transpose is
/// built from cofactors, which exist for flat models (a scale of 0) too.
inline Mat3d normal_matrix(const Transform& transform, NormalTransform how) {
  const Vec3d& s = transform.scale;
  Mat3d scale{0.0};
  switch (how) {
  case NormalTransform::model:
    scale[0][0] = s.x;
    scale[1][1] = s.y;
    scale[2][2] = s.z;
    break;
  case NormalTransform::inverse_transpose: {
    const double sign = (s.x < 0) != ((s.y < 0) != (s.z < 0)) ? -1 : 1;
    scale[0][0] = sign * s.y * s.z;
    scale[1][1] = sign * s.z * s.x;
    scale[2][2] = sign * s.x * s.y;
    break;
  }
  }
  const Mat3d& r = transform.rotation;
  if (how == NormalTransform::model) return r * scale;
  const Mat3d cofactors{cross(r[1], r[2]), cross(r[2], r[0]), cross(r[0], r[1])};  // columns; r itself if orthonormal
  const double sign = dot(r[0], cofactors[0]) < 0 ? -1 : 1;
  return cofactors * sign * scale;
}

/// A vertex normal in the world, brought to length 1; zero stays zero.
inline Vec3d normal_to_world(const Mat3d& matrix, const Vec3d& normal) { return unit_or_zero(matrix * normal); }

}  // namespace ps
