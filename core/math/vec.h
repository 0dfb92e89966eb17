#pragma once
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace ps {

/// Kernels are templates over Real (float or double); these are their vectors. Matrices are GLM's: column-major,
/// m[column][row], applied to column vectors from the left.
template <class Real>
using Vec2 = glm::vec<2, Real, glm::defaultp>;
template <class Real>
using Vec3 = glm::vec<3, Real, glm::defaultp>;
template <class Real>
using Vec4 = glm::vec<4, Real, glm::defaultp>;
template <class Real>
using Mat3 = glm::mat<3, 3, Real, glm::defaultp>;
template <class Real>
using Mat4 = glm::mat<4, 4, Real, glm::defaultp>;

using Vec2f = Vec2<float>;
using Vec3f = Vec3<float>;
using Vec4f = Vec4<float>;
using Vec2d = Vec2<double>;
using Vec3d = Vec3<double>;
using Vec4d = Vec4<double>;
using Vec2i = glm::vec<2, int, glm::defaultp>;
using Mat3d = Mat3<double>;
using Mat4d = Mat4<double>;

/// Sum of products from left to right: the order is part of the contract, since the fast path must repeat it and
/// the book's pictures depend on it.
template <class Real>
inline Real dot(const Vec3<Real>& a, const Vec3<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
inline Vec3<Real> cross(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace ps
