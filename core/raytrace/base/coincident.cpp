#include "raytrace/base/coincident.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>

#include "base/stop.h"

namespace ps {
namespace {

/// What decides where a primitive lies: vertices from the lowest to the highest, or a box. -0 is 0.
template <class Real>
using PlaceOfPrimitive = std::array<Real, 9>;

template <class Real>
PlaceOfPrimitive<Real> place_of_primitive(const TracedGeometry<Real>& geometry, const Primitive& primitive) {
  PlaceOfPrimitive<Real> place{};
  if (primitive.kind != PrimitiveKind::triangle) {
    const Box<Real> box = primitive_box(geometry, primitive);
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      place[i] = box.low[axis] + Real(0);
      place[3 + i] = box.high[axis] + Real(0);
    }
    return place;
  }
  const TracedTriangle<Real>& triangle = geometry.triangles[primitive.shape];
  std::array<std::array<Real, 3>, 3> corners;
  const std::array<const Vec3<Real>*, 3> given{&triangle.a, &triangle.b, &triangle.c};
  for (std::size_t k = 0; k < 3; ++k)
    corners[k] = {given[k]->x + Real(0), given[k]->y + Real(0), given[k]->z + Real(0)};
  std::sort(corners.begin(), corners.end());
  for (std::size_t k = 0; k < 9; ++k) place[k] = corners[k / 3][k % 3];
  return place;
}

template <class Real>
std::uint64_t hash_of_place(const PlaceOfPrimitive<Real>& place, PrimitiveKind kind) {
  std::uint64_t hash = 0xcbf29ce484222325u + static_cast<std::uint64_t>(kind);
  for (const Real number : place) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof number);
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  return hash;
}

}  // namespace

template <class Real>
std::vector<std::uint32_t> coincident_primitives(const TracedGeometry<Real>& geometry) {
  const std::uint32_t count = bounded_count(geometry);
  const auto primitive = [&](std::uint32_t i) -> const Primitive& {
    return geometry.primitives[bounded_primitive(geometry, i)];
  };
  struct Hashed {
    std::uint64_t hash;
    std::uint32_t index;
  };
  std::vector<Hashed> hashed(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i % 4096 == 0) check_stop();
    hashed[i] = {hash_of_place(place_of_primitive(geometry, primitive(i)), primitive(i).kind), i};
  }
  std::sort(hashed.begin(), hashed.end(),
            [](const Hashed& a, const Hashed& b) { return a.hash != b.hash ? a.hash < b.hash : a.index < b.index; });
  std::vector<std::uint32_t> first(count);
  for (std::size_t begin = 0, k = 0; k < hashed.size(); ++k) {
    if (k % 4096 == 0) check_stop();
    if (hashed[k].hash != hashed[begin].hash) begin = k;
    const std::uint32_t i = hashed[k].index, earlier = hashed[begin].index;
    const bool same = primitive(i).kind == primitive(earlier).kind &&
                      place_of_primitive(geometry, primitive(i)) == place_of_primitive(geometry, primitive(earlier));
    first[i] = same ? earlier : i;  // two places with one hash: the later one stays by itself
  }
  return first;
}

template std::vector<std::uint32_t> coincident_primitives(const TracedGeometry<float>&);
template std::vector<std::uint32_t> coincident_primitives(const TracedGeometry<double>&);

}  // namespace ps
