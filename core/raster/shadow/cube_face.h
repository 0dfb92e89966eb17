#pragma once
#include <array>
#include <cmath>

#include "math/vec.h"
#include "scene/camera.h"

namespace ps::raster {

/// One side of the cube around a point, as a camera with a right angle of view sees it (CGFS ch. 15). The frames fit
/// together as a cross: +y above +z, -y below it, -x to its left, +x and then -z to its right.
struct CubeFace {
  Vec3d right, up, forward;
};

/// In the order +x -x +y -y +z -z.
inline const std::array<CubeFace, 6>& cube_faces() {
  static const std::array<CubeFace, 6> faces{{{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}},
                                              {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}},
                                              {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                                              {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                              {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                              {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}};
  return faces;
}

/// The camera that sees this face and nothing else.
inline Camera cube_camera(const CubeFace& face, const Vec3d& position) {
  Camera camera;
  camera.position = position;
  camera.right = face.right;
  camera.up = face.up;
  camera.forward = face.forward;
  camera.viewport_width = 2;
  camera.viewport_height = 2;
  camera.projection_plane_d = 1;
  return camera;
}

/// The face that a direction goes through: that of its longest component; of equal ones the first axis.
template <class Real>
int cube_face_of(const Vec3<Real>& direction) {
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(direction[i]) > std::abs(direction[axis])) axis = i;
  return 2 * axis + (direction[axis] < 0 ? 1 : 0);
}

/// A direction in a face's own coordinates: along its right, up and forward.
template <class Real>
Vec3<Real> in_face(const CubeFace& face, const Vec3<Real>& direction) {
  return {dot(Vec3<Real>(face.right), direction), dot(Vec3<Real>(face.up), direction),
          dot(Vec3<Real>(face.forward), direction)};
}

/// Where on a face of size x size texels a direction in its coordinates goes through: texels from the top left.
template <class Real>
Vec2<Real> face_position(const Vec3<Real>& local, int size) {
  const Real half = static_cast<Real>(size) / 2;
  return {half + half * local.x / local.z, half - half * local.y / local.z};
}

/// The opposite: the direction in a face's coordinates of a position on it.
template <class Real>
Vec3<Real> face_direction(const Vec2<Real>& position, int size) {
  const Real half = static_cast<Real>(size) / 2;
  return {(position.x - half) / half, (half - position.y) / half, Real(1)};
}

}  // namespace ps::raster
