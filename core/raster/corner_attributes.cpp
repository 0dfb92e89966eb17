#include "raster/corner_attributes.h"

#include <cmath>

#include "raster/light_at.h"

namespace ps::raster {
namespace {

template <class Real>
void put(CornerAttributes<Real>& corner, int slot, const Vec3<Real>& value) {
  if (slot == AttributeLayout::absent) return;
  for (int i = 0; i < 3; ++i) corner[static_cast<std::size_t>(slot + i)] = value[i];
}

}  // namespace

template <class Real>
std::array<CornerAttributes<Real>, 3> corner_attributes(const Pass<Real>& pass, const Surface<Real>& surface,
                                                        const CornerSource<Real>& source, CountingRecorder& recorder) {
  const AttributeLayout& layout = surface.layout;
  const Normals normals = pass.settings.normals;
  std::array<CornerAttributes<Real>, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    if (layout.normal != AttributeLayout::absent) put(corners[k], layout.normal, source.normal(k, normals));
    if (layout.position != AttributeLayout::absent) put(corners[k], layout.position, source.position(k));
    const auto uv = source.triangle->uv[k];
    if (layout.uv != AttributeLayout::absent) {
      const Vec2d value = uv >= 0 ? source.mesh->uvs[static_cast<std::size_t>(uv)] : Vec2d(0);
      corners[k][static_cast<std::size_t>(layout.uv)] = static_cast<Real>(value.x);
      corners[k][static_cast<std::size_t>(layout.uv) + 1] = static_cast<Real>(value.y);
    }
    if (layout.light != AttributeLayout::absent) {
      const Lighting<Real> lighting = light_at(pass, surface, source.position(k), source.normal(k, normals), recorder);
      put(corners[k], layout.light, lighting.light);
      put(corners[k], layout.extra, lighting.extra);
    }
  }
  return corners;
}

template <class Real>
FlatPoint<Real> flat_point(const CornerSource<Real>& source, Normals normals) {
  const auto mean = [](const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& c) { return (a + b + c) / Real(3); };
  FlatPoint<Real> point;
  point.position = mean(source.position(0), source.position(1), source.position(2));
  point.normal = mean(source.normal(0, normals), source.normal(1, normals), source.normal(2, normals));
  const Real size = std::sqrt(dot(point.normal, point.normal));
  if (size > 0) point.normal /= size;
  return point;
}

#define PS_INSTANTIATE(Real)                                                                                           \
  template std::array<CornerAttributes<Real>, 3> corner_attributes(const Pass<Real>&, const Surface<Real>&,            \
                                                                   const CornerSource<Real>&, CountingRecorder&);      \
  template FlatPoint<Real> flat_point(const CornerSource<Real>&, Normals);
PS_INSTANTIATE(float)
PS_INSTANTIATE(double)
#undef PS_INSTANTIATE

}  // namespace ps::raster
